"""The renderer's core: scene description, settings, sessions, images.

Structs are plain data with the meaning of the C++ headers of the same names. Lists and arrays are
copied on reading and on writing: assign the whole to change a part.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, final

import numpy as np
import numpy.typing as npt

__version__: str

class Error(RuntimeError): ...
class SceneError(Error): ...
class SettingsError(Error): ...
class FileError(Error): ...

_Floats = Sequence[float]
_Matrix = npt.NDArray[np.float64]

@final
class TextureWrap:
    UseMetadata: TextureWrap
    Black: TextureWrap
    Clamp: TextureWrap
    Repeat: TextureWrap
    Mirror: TextureWrap
    __members__: dict[str, TextureWrap]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class TextureColorSpace:
    Auto: TextureColorSpace
    Raw: TextureColorSpace
    Srgb: TextureColorSpace
    __members__: dict[str, TextureColorSpace]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class PreviewOpacityMode:
    Transparent: PreviewOpacityMode
    Presence: PreviewOpacityMode
    __members__: dict[str, PreviewOpacityMode]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class PhongForm:
    Modified: PhongForm
    Classic: PhongForm
    __members__: dict[str, PhongForm]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class Interpolation:
    Constant: Interpolation
    Uniform: Interpolation
    Vertex: Interpolation
    FaceVarying: Interpolation
    __members__: dict[str, Interpolation]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class Axis:
    X: Axis
    Y: Axis
    Z: Axis
    __members__: dict[str, Axis]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class LightKind:
    Rect: LightKind
    Disk: LightKind
    Sphere: LightKind
    Cylinder: LightKind
    Distant: LightKind
    Dome: LightKind
    Mesh: LightKind
    __members__: dict[str, LightKind]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class CameraProjection:
    Perspective: CameraProjection
    Orthographic: CameraProjection
    __members__: dict[str, CameraProjection]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class ApertureConform:
    ExpandAperture: ApertureConform
    CropAperture: ApertureConform
    AdjustApertureWidth: ApertureConform
    AdjustApertureHeight: ApertureConform
    AdjustPixelAspect: ApertureConform
    __members__: dict[str, ApertureConform]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class IntegratorKind:
    Path: IntegratorKind
    Light: IntegratorKind
    Bdpt: IntegratorKind
    Auto: IntegratorKind
    __members__: dict[str, IntegratorKind]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class MisHeuristic:
    Balance: MisHeuristic
    Power: MisHeuristic
    __members__: dict[str, MisHeuristic]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class Aov:
    Color: Aov
    Alpha: Aov
    Depth: Aov
    Normal: Aov
    Albedo: Aov
    SampleCount: Aov
    Variance: Aov
    __members__: dict[str, Aov]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class FilterKind:
    Box: FilterKind
    Triangle: FilterKind
    Gaussian: FilterKind
    __members__: dict[str, FilterKind]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class ImageFileKind:
    SceneLinear: ImageFileKind
    Display: ImageFileKind
    __members__: dict[str, ImageFileKind]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

class TextureDesc:
    def __init__(
        self,
        *,
        name: str = ...,
        file: str = ...,
        color_space: TextureColorSpace = ...,
        wrap_s: TextureWrap = ...,
        wrap_t: TextureWrap = ...,
        scale: _Floats = ...,
        bias: _Floats = ...,
        fallback: _Floats = ...,
        st_transform: _Floats = ...,
    ) -> None: ...
    name: str
    file: str
    color_space: TextureColorSpace
    wrap_s: TextureWrap
    wrap_t: TextureWrap
    @property
    def scale(self) -> list[float]: ...
    @scale.setter
    def scale(self, value: _Floats, /) -> None: ...
    @property
    def bias(self) -> list[float]: ...
    @bias.setter
    def bias(self, value: _Floats, /) -> None: ...
    @property
    def fallback(self) -> list[float]: ...
    @fallback.setter
    def fallback(self, value: _Floats, /) -> None: ...
    @property
    def st_transform(self) -> list[float]: ...
    @st_transform.setter
    def st_transform(self, value: _Floats, /) -> None: ...

class ColorInput:
    def __init__(
        self,
        *,
        value: _Floats = ...,
        texture: int = ...,
    ) -> None: ...
    @property
    def value(self) -> list[float]: ...
    @value.setter
    def value(self, value: _Floats, /) -> None: ...
    texture: int

class FloatInput:
    def __init__(
        self,
        *,
        value: float = ...,
        texture: int = ...,
        channel: int = ...,
    ) -> None: ...
    value: float
    texture: int
    channel: int

class DiffuseMaterial:
    def __init__(
        self,
        *,
        reflectance: ColorInput = ...,
        roughness: FloatInput = ...,
    ) -> None: ...
    reflectance: ColorInput
    roughness: FloatInput

class ConductorMaterial:
    def __init__(
        self,
        *,
        reflectance: ColorInput = ...,
        roughness: FloatInput = ...,
    ) -> None: ...
    reflectance: ColorInput
    roughness: FloatInput

class DielectricMaterial:
    def __init__(
        self,
        *,
        ior: float = ...,
        roughness: FloatInput = ...,
        reflection_tint: ColorInput = ...,
        transmission_tint: ColorInput = ...,
        thin_walled: bool = ...,
        transmission_depth: float = ...,
    ) -> None: ...
    ior: float
    roughness: FloatInput
    reflection_tint: ColorInput
    transmission_tint: ColorInput
    thin_walled: bool
    transmission_depth: float

class PreviewSurfaceMaterial:
    def __init__(
        self,
        *,
        diffuse_color: ColorInput = ...,
        use_specular_workflow: bool = ...,
        specular_color: ColorInput = ...,
        metallic: FloatInput = ...,
        roughness: FloatInput = ...,
        clearcoat: FloatInput = ...,
        clearcoat_roughness: FloatInput = ...,
        opacity: FloatInput = ...,
        opacity_mode: PreviewOpacityMode = ...,
        opacity_threshold: float = ...,
        ior: float = ...,
    ) -> None: ...
    diffuse_color: ColorInput
    use_specular_workflow: bool
    specular_color: ColorInput
    metallic: FloatInput
    roughness: FloatInput
    clearcoat: FloatInput
    clearcoat_roughness: FloatInput
    opacity: FloatInput
    opacity_mode: PreviewOpacityMode
    opacity_threshold: float
    ior: float

class OpenPbrMaterial:
    def __init__(
        self,
        *,
        base_weight: FloatInput = ...,
        base_color: ColorInput = ...,
        base_diffuse_roughness: FloatInput = ...,
        base_metalness: FloatInput = ...,
        specular_weight: FloatInput = ...,
        specular_color: ColorInput = ...,
        specular_roughness: FloatInput = ...,
        specular_ior: float = ...,
        transmission_weight: FloatInput = ...,
        transmission_color: ColorInput = ...,
        transmission_depth: float = ...,
        coat_weight: FloatInput = ...,
        coat_roughness: FloatInput = ...,
        coat_ior: float = ...,
        coat_darkening: FloatInput = ...,
        geometry_opacity: FloatInput = ...,
        geometry_thin_walled: bool = ...,
    ) -> None: ...
    base_weight: FloatInput
    base_color: ColorInput
    base_diffuse_roughness: FloatInput
    base_metalness: FloatInput
    specular_weight: FloatInput
    specular_color: ColorInput
    specular_roughness: FloatInput
    specular_ior: float
    transmission_weight: FloatInput
    transmission_color: ColorInput
    transmission_depth: float
    coat_weight: FloatInput
    coat_roughness: FloatInput
    coat_ior: float
    coat_darkening: FloatInput
    geometry_opacity: FloatInput
    geometry_thin_walled: bool

class PhongMaterial:
    def __init__(
        self,
        *,
        reflectance: ColorInput = ...,
        exponent: FloatInput = ...,
        form: PhongForm = ...,
    ) -> None: ...
    reflectance: ColorInput
    exponent: FloatInput
    form: PhongForm

MaterialModel = (
    DiffuseMaterial
    | ConductorMaterial
    | DielectricMaterial
    | PreviewSurfaceMaterial
    | OpenPbrMaterial
    | PhongMaterial
)

class MaterialDesc:
    def __init__(
        self,
        *,
        name: str = ...,
        model: MaterialModel = ...,
        emission: ColorInput = ...,
        normal_texture: int = ...,
    ) -> None: ...
    name: str
    model: MaterialModel
    emission: ColorInput
    normal_texture: int

class MeshDesc:
    """Points, normals: (n, 3) float32; st: (n, 2) float32; the others: (n,) int32."""

    def __init__(
        self,
        *,
        points: npt.ArrayLike = ...,
        face_vertex_counts: npt.NDArray[np.integer[Any]] = ...,
        face_vertex_indices: npt.NDArray[np.integer[Any]] = ...,
        normals: npt.ArrayLike = ...,
        normals_interpolation: Interpolation = ...,
        st: npt.ArrayLike = ...,
        st_interpolation: Interpolation = ...,
        face_materials: npt.NDArray[np.integer[Any]] = ...,
        left_handed: bool = ...,
    ) -> None: ...
    @property
    def points(self) -> npt.NDArray[np.float32]: ...
    @points.setter
    def points(self, value: npt.ArrayLike, /) -> None: ...
    @property
    def face_vertex_counts(self) -> npt.NDArray[np.int32]: ...
    @face_vertex_counts.setter
    def face_vertex_counts(self, value: npt.NDArray[np.integer[Any]], /) -> None: ...
    @property
    def face_vertex_indices(self) -> npt.NDArray[np.int32]: ...
    @face_vertex_indices.setter
    def face_vertex_indices(self, value: npt.NDArray[np.integer[Any]], /) -> None: ...
    @property
    def normals(self) -> npt.NDArray[np.float32]: ...
    @normals.setter
    def normals(self, value: npt.ArrayLike, /) -> None: ...
    normals_interpolation: Interpolation
    @property
    def st(self) -> npt.NDArray[np.float32]: ...
    @st.setter
    def st(self, value: npt.ArrayLike, /) -> None: ...
    st_interpolation: Interpolation
    @property
    def face_materials(self) -> npt.NDArray[np.int32]: ...
    @face_materials.setter
    def face_materials(self, value: npt.NDArray[np.integer[Any]], /) -> None: ...
    left_handed: bool

class SphereDesc:
    def __init__(
        self,
        *,
        radius: float = ...,
    ) -> None: ...
    radius: float

class CubeDesc:
    def __init__(
        self,
        *,
        size: float = ...,
    ) -> None: ...
    size: float

class CylinderDesc:
    def __init__(
        self,
        *,
        radius: float = ...,
        height: float = ...,
        axis: Axis = ...,
    ) -> None: ...
    radius: float
    height: float
    axis: Axis

class ConeDesc:
    def __init__(
        self,
        *,
        radius: float = ...,
        height: float = ...,
        axis: Axis = ...,
    ) -> None: ...
    radius: float
    height: float
    axis: Axis

class CapsuleDesc:
    def __init__(
        self,
        *,
        radius: float = ...,
        height: float = ...,
        axis: Axis = ...,
    ) -> None: ...
    radius: float
    height: float
    axis: Axis

class PlaneDesc:
    def __init__(
        self,
        *,
        width: float = ...,
        length: float = ...,
        axis: Axis = ...,
    ) -> None: ...
    width: float
    length: float
    axis: Axis

GeometryDesc = MeshDesc | SphereDesc | CubeDesc | CylinderDesc | ConeDesc | CapsuleDesc | PlaneDesc

class ShapeDesc:
    """parent_from_object: (4, 4), for column vectors."""

    def __init__(
        self,
        *,
        name: str = ...,
        geometry: int = ...,
        materials: Sequence[int] = ...,
        parent_from_object: npt.ArrayLike = ...,
    ) -> None: ...
    name: str
    geometry: int
    @property
    def materials(self) -> list[int]: ...
    @materials.setter
    def materials(self, value: Sequence[int], /) -> None: ...
    @property
    def parent_from_object(self) -> _Matrix: ...
    @parent_from_object.setter
    def parent_from_object(self, value: npt.ArrayLike, /) -> None: ...

class GroupDesc:
    def __init__(
        self,
        *,
        name: str = ...,
        shapes: Sequence[ShapeDesc] = ...,
    ) -> None: ...
    name: str
    @property
    def shapes(self) -> list[ShapeDesc]: ...
    @shapes.setter
    def shapes(self, value: Sequence[ShapeDesc], /) -> None: ...

class InstanceDesc:
    """world_from_group: (4, 4), for column vectors."""

    def __init__(
        self,
        *,
        name: str = ...,
        group: int = ...,
        world_from_group: npt.ArrayLike = ...,
    ) -> None: ...
    name: str
    group: int
    @property
    def world_from_group(self) -> _Matrix: ...
    @world_from_group.setter
    def world_from_group(self, value: npt.ArrayLike, /) -> None: ...

class ShapingDesc:
    def __init__(
        self,
        *,
        focus: float = ...,
        focus_tint: _Floats = ...,
        cone_angle: float = ...,
        cone_softness: float = ...,
    ) -> None: ...
    focus: float
    @property
    def focus_tint(self) -> list[float]: ...
    @focus_tint.setter
    def focus_tint(self, value: _Floats, /) -> None: ...
    cone_angle: float
    cone_softness: float

class LightDesc:
    """world_from_light: (4, 4), for column vectors."""

    def __init__(
        self,
        *,
        name: str = ...,
        kind: LightKind = ...,
        world_from_light: npt.ArrayLike = ...,
        intensity: float = ...,
        exposure: float = ...,
        color: _Floats = ...,
        color_temperature_rgb: _Floats = ...,
        normalize: bool = ...,
        width: float = ...,
        height: float = ...,
        length: float = ...,
        radius: float = ...,
        treat_as_point: bool = ...,
        treat_as_line: bool = ...,
        angle: float = ...,
        texture_file: str = ...,
        texture_color_space: TextureColorSpace = ...,
        pole_axis: Axis = ...,
        shaping: ShapingDesc | None = ...,
        shape: int = ...,
        tinted_by_material: bool = ...,
    ) -> None: ...
    name: str
    kind: LightKind
    @property
    def world_from_light(self) -> _Matrix: ...
    @world_from_light.setter
    def world_from_light(self, value: npt.ArrayLike, /) -> None: ...
    intensity: float
    exposure: float
    @property
    def color(self) -> list[float]: ...
    @color.setter
    def color(self, value: _Floats, /) -> None: ...
    @property
    def color_temperature_rgb(self) -> list[float]: ...
    @color_temperature_rgb.setter
    def color_temperature_rgb(self, value: _Floats, /) -> None: ...
    normalize: bool
    width: float
    height: float
    length: float
    radius: float
    treat_as_point: bool
    treat_as_line: bool
    angle: float
    texture_file: str
    texture_color_space: TextureColorSpace
    pole_axis: Axis
    shaping: ShapingDesc | None
    shape: int
    tinted_by_material: bool

class CameraDesc:
    """world_from_camera: (4, 4), for column vectors."""

    def __init__(
        self,
        *,
        name: str = ...,
        projection: CameraProjection = ...,
        world_from_camera: npt.ArrayLike = ...,
        horizontal_aperture: float = ...,
        vertical_aperture: float = ...,
        horizontal_aperture_offset: float = ...,
        vertical_aperture_offset: float = ...,
        focal_length: float = ...,
        f_stop: float = ...,
        focus_distance: float = ...,
        exposure_scale: float = ...,
    ) -> None: ...
    name: str
    projection: CameraProjection
    @property
    def world_from_camera(self) -> _Matrix: ...
    @world_from_camera.setter
    def world_from_camera(self, value: npt.ArrayLike, /) -> None: ...
    horizontal_aperture: float
    vertical_aperture: float
    horizontal_aperture_offset: float
    vertical_aperture_offset: float
    focal_length: float
    f_stop: float
    focus_distance: float
    exposure_scale: float

class AdjointPolicy:
    def __init__(
        self,
        *,
        refraction: bool = ...,
        shading_normal: bool = ...,
        phong: bool = ...,
    ) -> None: ...
    refraction: bool
    shading_normal: bool
    phong: bool

class StrategySet:
    def __init__(
        self,
        *,
        emission_hit: bool = ...,
        direct_light: bool = ...,
        connection: bool = ...,
        light_image: bool = ...,
        lens_hit: bool = ...,
    ) -> None: ...
    emission_hit: bool
    direct_light: bool
    connection: bool
    light_image: bool
    lens_hit: bool

class Strategy:
    def __init__(
        self,
        *,
        s: int = ...,
        t: int = ...,
    ) -> None: ...
    s: int
    t: int

class PixelFilter:
    def __init__(
        self,
        *,
        kind: FilterKind = ...,
        radius: float = ...,
    ) -> None: ...
    kind: FilterKind
    radius: float

class PixelWindow:
    def __init__(
        self,
        *,
        x0: int = ...,
        y0: int = ...,
        x1: int = ...,
        y1: int = ...,
    ) -> None: ...
    x0: int
    y0: int
    x1: int
    y1: int

class RenderSettings:
    def __init__(
        self,
        *,
        camera: int = ...,
        width: int = ...,
        height: int = ...,
        crop: PixelWindow | None = ...,
        conform: ApertureConform = ...,
        integrator: IntegratorKind = ...,
        samples_per_pixel: int = ...,
        time_limit: float = ...,
        error_target: float = ...,
        adaptive: bool = ...,
        max_depth: int = ...,
        seed: int = ...,
        threads: int = ...,
        texture_memory: float = ...,
        filter: PixelFilter = ...,  # noqa: A002 - the attribute's name
        heuristic: MisHeuristic = ...,
        strategies: StrategySet = ...,
        single_strategy: Strategy | None = ...,
        light_paths_per_pixel: float | None = ...,
        roulette_depth: int = ...,
        adjoint: AdjointPolicy = ...,
        aovs: Sequence[Aov] = ...,
        strategy_images: int = ...,
    ) -> None: ...
    camera: int
    width: int
    height: int
    crop: PixelWindow | None
    conform: ApertureConform
    integrator: IntegratorKind
    samples_per_pixel: int
    time_limit: float
    error_target: float
    adaptive: bool
    max_depth: int
    seed: int
    threads: int
    texture_memory: float
    filter: PixelFilter
    heuristic: MisHeuristic
    strategies: StrategySet
    single_strategy: Strategy | None
    light_paths_per_pixel: float | None
    roulette_depth: int
    adjoint: AdjointPolicy
    @property
    def aovs(self) -> list[Aov]: ...
    @aovs.setter
    def aovs(self, value: Sequence[Aov], /) -> None: ...
    strategy_images: int

class SceneDescription:
    """Lists are read as copies and replaced as a whole; add_*() append and return the index."""

    source: str
    def __init__(self) -> None: ...
    @property
    def textures(self) -> list[TextureDesc]: ...
    @textures.setter
    def textures(self, value: Sequence[TextureDesc], /) -> None: ...
    def add_texture(self, item: TextureDesc) -> int: ...
    @property
    def materials(self) -> list[MaterialDesc]: ...
    @materials.setter
    def materials(self, value: Sequence[MaterialDesc], /) -> None: ...
    def add_material(self, item: MaterialDesc) -> int: ...
    @property
    def geometries(self) -> list[GeometryDesc]: ...
    @geometries.setter
    def geometries(self, value: Sequence[GeometryDesc], /) -> None: ...
    def add_geometry(self, item: GeometryDesc) -> int: ...
    @property
    def shapes(self) -> list[ShapeDesc]: ...
    @shapes.setter
    def shapes(self, value: Sequence[ShapeDesc], /) -> None: ...
    def add_shape(self, item: ShapeDesc) -> int: ...
    @property
    def groups(self) -> list[GroupDesc]: ...
    @groups.setter
    def groups(self, value: Sequence[GroupDesc], /) -> None: ...
    def add_group(self, item: GroupDesc) -> int: ...
    @property
    def instances(self) -> list[InstanceDesc]: ...
    @instances.setter
    def instances(self, value: Sequence[InstanceDesc], /) -> None: ...
    def add_instance(self, item: InstanceDesc) -> int: ...
    @property
    def lights(self) -> list[LightDesc]: ...
    @lights.setter
    def lights(self, value: Sequence[LightDesc], /) -> None: ...
    def add_light(self, item: LightDesc) -> int: ...
    @property
    def cameras(self) -> list[CameraDesc]: ...
    @cameras.setter
    def cameras(self, value: Sequence[CameraDesc], /) -> None: ...
    def add_camera(self, item: CameraDesc) -> int: ...
    def add_instances(self, name: str, group: int, world_from_group: npt.ArrayLike) -> None:
        """One instance for each of the matrices (n, 4, 4), named name[0], name[1], ..."""

    def copy(self) -> SceneDescription: ...

DARKEST_PART: float
"""A pixel darker than this part of the mean counts about as that bright in relative errors."""

def aov_name(aov: Aov) -> str: ...
def aov_channels(aov: Aov) -> int: ...

@final
class ChosenMethod:
    """What the integrator "auto" makes of a scene; as settings, they repeat the render."""

    @property
    def integrator(self) -> IntegratorKind: ...
    @property
    def light_paths_per_pixel(self) -> float | None:
        """None: as RenderSettings has it."""

@final
class RenderStatistics:
    @property
    def passes(self) -> int: ...
    @property
    def seconds(self) -> float: ...
    @property
    def error(self) -> float:
        """sqrt(relMSE) that the picture's own noise lets expect; inf while unknown: before 8
        passes, and before 16 while the render runs."""

    @property
    def chosen(self) -> ChosenMethod | None:
        """By the integrator "auto"; None until it has, and for others."""

    @property
    def camera_paths(self) -> int: ...
    @property
    def light_paths(self) -> int: ...
    @property
    def rays(self) -> int: ...
    @property
    def invalid(self) -> dict[str, int]:
        """Contributions that were refused: "nan", "infinite", "negative"."""

@final
class RenderedImage:
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def window(self) -> PixelWindow: ...
    @property
    def full_width(self) -> int: ...
    @property
    def full_height(self) -> int: ...
    @property
    def statistics(self) -> RenderStatistics: ...
    @property
    def aovs(self) -> list[Aov]: ...
    def array(self, aov: Aov) -> npt.NDArray[np.float32]:
        """A new array (h, w, channels), or (h, w) for one channel. KeyError when it is absent."""
    @property
    def strategy_images(self) -> list[str]: ...
    def strategy_array(self, name: str) -> npt.NDArray[np.float32]:
        """A new array (h, w, 3). KeyError when there is none of that name."""

@final
class RenderProgress:
    @property
    def passes_done(self) -> int: ...
    @property
    def passes_total(self) -> int:
        """0 when they are not limited."""

    @property
    def fraction(self) -> float:
        """0..1, by whichever limit is nearer; a forecast, which may fall, where that is the
        error's."""

    @property
    def seconds(self) -> float: ...
    @property
    def error(self) -> float:
        """RenderStatistics.error as last estimated; inf while unknown."""

    @property
    def finished(self) -> bool: ...

@final
class PickedSurface:
    """What a point of the picture shows, by indices into the scene's description."""

    @property
    def shape(self) -> int:
        """Of `shapes`, or of an instance's group; -1: a light."""

    @property
    def instance(self) -> int:
        """-1: none."""

    @property
    def triangle(self) -> int:
        """Faces of n corners are cut into n - 2 triangles, in order; 0 on an exact surface."""

@final
class CoordinateUse:
    Unused: CoordinateUse
    Lookup: CoordinateUse
    Tangents: CoordinateUse
    __members__: dict[str, CoordinateUse]
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class LobeSet:
    @property
    def diffuse(self) -> bool: ...
    @property
    def smooth_reflection(self) -> bool: ...
    @property
    def rough_reflection(self) -> bool: ...
    @property
    def smooth_transmission(self) -> bool: ...
    @property
    def rough_transmission(self) -> bool: ...
    @property
    def cutout(self) -> bool: ...

@final
class LightSet:
    @property
    def areas(self) -> bool: ...
    @property
    def emitting_surfaces(self) -> bool: ...
    @property
    def points(self) -> bool: ...
    @property
    def suns(self) -> bool: ...
    @property
    def domes(self) -> bool: ...

@final
class Requirements:
    """What a render has to have: nothing else is converted, opened, sampled or stored."""

    @property
    def materials(self) -> list[bool]: ...
    @property
    def textures(self) -> list[list[bool]]: ...
    @property
    def texture_coordinates(self) -> list[CoordinateUse]: ...
    @property
    def lobes(self) -> LobeSet: ...
    @property
    def lights(self) -> LightSet: ...
    @property
    def strategies(self) -> StrategySet: ...
    @property
    def light_paths(self) -> bool: ...
    @property
    def thin_lens(self) -> bool: ...
    @property
    def absorption(self) -> bool: ...
    @property
    def instances(self) -> bool: ...
    @property
    def normals(self) -> bool: ...
    @property
    def normal_maps(self) -> bool: ...
    @property
    def first_surface(self) -> bool: ...
    @property
    def replicates(self) -> bool: ...
    @property
    def aovs(self) -> list[Aov]: ...

def find_requirements(scene: SceneDescription, settings: RenderSettings) -> Requirements:
    """Derived from descriptions: no file is looked at."""

@final
class MemoryUse:
    """Bytes that the parts of a render hold; what building takes for a while is not in it."""

    @property
    def vertices(self) -> int: ...
    @property
    def acceleration(self) -> int: ...
    @property
    def lights(self) -> int: ...
    @property
    def textures(self) -> int: ...
    @property
    def textures_limit(self) -> int: ...
    @property
    def film(self) -> int: ...

@final
class RenderSession:
    """One progressive render in the background. No call holds the GIL while it waits."""

    def __init__(
        self,
        scene: SceneDescription,
        settings: RenderSettings,
        callback: Callable[[RenderProgress], object] | None = None,
        spend_scene: bool = False,
    ) -> None:
        """`spend_scene`: nobody needs the scene any more, which loses its geometries."""

    def start(self) -> None: ...
    def cancel(self) -> None: ...
    def wait(self) -> None:
        """Raises what ended the render early, an exception of the callback included."""

    def wait_for(self, seconds: float) -> bool: ...
    @property
    def progress(self) -> RenderProgress: ...
    def snapshot(self) -> RenderedImage: ...
    @property
    def requirements(self) -> Requirements: ...
    @property
    def memory_use(self) -> MemoryUse: ...
    def pick(self, x: float, y: float) -> PickedSurface | None:
        """The nearest surface behind a point of the full image (pixels, row 0 on top)."""

@final
class ColorConfig:
    def __init__(self, file: str = "") -> None: ...
    @property
    def source(self) -> str: ...
    @property
    def displays(self) -> list[str]: ...
    def views(self, display: str) -> list[str]: ...
    @property
    def default_display(self) -> str: ...
    def default_view(self, display: str) -> str: ...
    def apply(
        self, rgb: npt.NDArray[np.float32], display: str = "", view: str = ""
    ) -> npt.NDArray[np.float32]:
        """A new array of display values in the shape of `rgb`, (..., 3)."""

def image_file_kind(file: str) -> ImageFileKind: ...
def check_writable(file: str) -> None: ...
def write_exr(file: str, image: RenderedImage, metadata: Mapping[str, str]) -> None: ...
def write_display_image(
    file: str,
    image: RenderedImage,
    config: ColorConfig,
    display: str = "",
    view: str = "",
    bits: int = 8,
) -> None: ...
