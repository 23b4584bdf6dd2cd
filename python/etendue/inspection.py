"""What a stage holds and what a render of it needs, as plain data."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from etendue import _core
from etendue.usd_reader import StageContents

# Rough bytes in memory per triangle and per instance, with what ray tracing adds to them.
_BYTES_PER_TRIANGLE = 150
_BYTES_PER_VERTEX = 32
_BYTES_PER_INSTANCE = 400


@dataclass(frozen=True)
class Requirements:
    """What must exist in a renderer for this stage. Textured inputs count as all their values."""

    smooth_reflection: bool
    smooth_transmission: bool
    rough_reflection: bool
    rough_transmission: bool
    cutouts: bool
    textures: bool
    normal_maps: bool
    area_lights: bool
    emitting_surfaces: bool
    point_lights: bool
    infinite_lights: bool
    thin_lens: bool


@dataclass(frozen=True)
class Inspection:
    """Counts, requirements and warnings of a stage at a frame."""

    source: str
    frame: float
    prims: dict[str, int]
    cameras: tuple[str, ...]
    render_settings: str | None
    resolution: tuple[int, int] | None
    geometries: dict[str, int]
    triangles: int
    instances: int
    instanced_triangles: int
    lights: dict[str, int]
    materials: dict[str, int]
    textures: tuple[str, ...]
    memory_bytes: int
    requirements: Requirements
    unsupported: tuple[str, ...]

    def to_dict(self) -> dict[str, object]:
        """For JSON."""
        return asdict(self)


def inspect_contents(contents: StageContents) -> Inspection:
    """Looks at what was read. Texture files are counted by their size on disk."""
    scene = contents.scene
    geometries = scene.geometries
    triangles = [_triangles(geometry) for geometry in geometries]
    groups = [sum(triangles[shape.geometry] for shape in group.shapes) for group in scene.groups]
    placed = Counter(instance.group for instance in scene.instances)
    files = {texture.file for texture in scene.textures}
    files |= {light.texture_file for light in scene.lights if light.texture_file}
    textures = sorted(files)
    return Inspection(
        source=contents.source,
        frame=contents.frame,
        prims=dict(sorted(contents.prims.items())),
        cameras=contents.cameras,
        render_settings=contents.settings.path,
        resolution=contents.settings.resolution,
        geometries=_counts(_name(geometry, "Desc") for geometry in geometries),
        triangles=sum(triangles),
        instances=sum(placed.values()),
        instanced_triangles=sum(triangles[shape.geometry] for shape in scene.shapes)
        + sum(groups[group] * count for group, count in placed.items()),
        lights=_counts(light.kind.name for light in scene.lights),
        materials=_counts(_name(material.model, "Material") for material in scene.materials),
        textures=tuple(textures),
        memory_bytes=sum(triangles) * _BYTES_PER_TRIANGLE
        + sum(_vertices(geometry) for geometry in geometries) * _BYTES_PER_VERTEX
        + sum(placed.values()) * _BYTES_PER_INSTANCE
        + sum(file.stat().st_size for file in map(Path, textures) if file.is_file()),
        requirements=_requirements(scene),
        unsupported=tuple(str(warning) for warning in contents.warnings),
    )


def _counts(names: Iterable[str]) -> dict[str, int]:
    return dict(sorted(Counter(names).items()))


def _name(value: object, suffix: str) -> str:
    return type(value).__name__.removesuffix(suffix)


def _triangles(geometry: object) -> int:
    """Of a mesh's fan triangulation; other solids are traced as they are."""
    if not isinstance(geometry, _core.MeshDesc):
        return 0
    counts = geometry.face_vertex_counts
    return int(np.maximum(counts.astype(np.int64) - 2, 0).sum())


def _vertices(geometry: object) -> int:
    return len(geometry.points) if isinstance(geometry, _core.MeshDesc) else 0


# ---------------------------------------------------------------------------------- requirements


def _requirements(scene: _core.SceneDescription) -> Requirements:
    lobes = [_lobes(material.model) for material in scene.materials]
    kinds = {light.kind for light in scene.lights}
    area_kinds = {
        _core.LightKind.Rect,
        _core.LightKind.Disk,
        _core.LightKind.Sphere,
        _core.LightKind.Cylinder,
        _core.LightKind.Mesh,
    }
    points = [light for light in scene.lights if _is_thin(light)]
    areas = sum(light.kind in area_kinds for light in scene.lights)
    return Requirements(
        smooth_reflection=any("smooth reflection" in lobe for lobe in lobes),
        smooth_transmission=any("smooth transmission" in lobe for lobe in lobes),
        rough_reflection=any("rough reflection" in lobe for lobe in lobes),
        rough_transmission=any("rough transmission" in lobe for lobe in lobes),
        cutouts=any("cutout" in lobe for lobe in lobes),
        textures=bool(scene.textures) or any(light.texture_file for light in scene.lights),
        normal_maps=any(material.normal_texture >= 0 for material in scene.materials),
        area_lights=areas > len(points),
        emitting_surfaces=any(
            material.emission.texture >= 0 or any(material.emission.value)
            for material in scene.materials
        ),
        point_lights=bool(points),
        infinite_lights=bool(kinds & {_core.LightKind.Distant, _core.LightKind.Dome}),
        thin_lens=any(camera.f_stop > 0 and camera.focus_distance > 0 for camera in scene.cameras),
    )


def _is_thin(light: _core.LightDesc) -> bool:
    """A point or a line."""
    if light.kind == _core.LightKind.Sphere:
        return light.treat_as_point or light.radius == 0
    return light.kind == _core.LightKind.Cylinder and (light.treat_as_line or light.radius == 0)


def _lobes(model: _core.MaterialModel) -> set[str]:
    if isinstance(model, _core.DiffuseMaterial):
        return set()
    if isinstance(model, _core.ConductorMaterial):
        return _by_roughness(model.roughness, "reflection")
    if isinstance(model, _core.DielectricMaterial):
        return _by_roughness(model.roughness, "reflection", "transmission")
    if isinstance(model, _core.PreviewSurfaceMaterial):
        return _preview_lobes(model)
    if isinstance(model, _core.PhongMaterial):
        return {"rough reflection"}
    lobes: set[str] = set()
    if _may_exceed(model.specular_weight, 0) or _may_exceed(model.base_metalness, 0):
        lobes |= _by_roughness(model.specular_roughness, "reflection")
    if _may_exceed(model.transmission_weight, 0):
        lobes |= _by_roughness(model.specular_roughness, "reflection", "transmission")
    if _may_exceed(model.coat_weight, 0):
        lobes |= _by_roughness(model.coat_roughness, "reflection")
    if _may_be_below(model.geometry_opacity, 1):
        lobes.add("cutout")
    return lobes


def _preview_lobes(model: _core.PreviewSurfaceMaterial) -> set[str]:
    lobes = _by_roughness(model.roughness, "reflection")
    if _may_exceed(model.clearcoat, 0):
        lobes |= _by_roughness(model.clearcoat_roughness, "reflection")
    if _may_be_below(model.opacity, 1):
        presence = model.opacity_mode == _core.PreviewOpacityMode.Presence
        if presence or model.opacity_threshold > 0:
            lobes.add("cutout")
        else:
            lobes.add("smooth transmission")
    return lobes


def _by_roughness(roughness: _core.FloatInput, *lobes: str) -> set[str]:
    found = set()
    if roughness.texture >= 0 or roughness.value <= 0:
        found |= {f"smooth {lobe}" for lobe in lobes}
    if _may_exceed(roughness, 0):
        found |= {f"rough {lobe}" for lobe in lobes}
    return found


def _may_exceed(value: _core.FloatInput, bound: float) -> bool:
    return value.texture >= 0 or value.value > bound


def _may_be_below(value: _core.FloatInput, bound: float) -> bool:
    return value.texture >= 0 or value.value < bound
