"""What a stage holds and what a render of it needs, as plain data."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import asdict, dataclass

import numpy as np

from etendue import _core
from etendue.settings import STRATEGIES, render_settings
from etendue.usd_reader import StageContents

_LOBES = (
    "diffuse",
    "smooth_reflection",
    "rough_reflection",
    "smooth_transmission",
    "rough_transmission",
    "cutout",
)
LIGHTS = ("areas", "emitting_surfaces", "points", "suns", "domes")
_MACHINERY = (
    "light_paths",
    "thin_lens",
    "absorption",
    "instances",
    "first_surface",
    "replicates",
)


@dataclass(frozen=True)
class Requirements:
    """What has to exist for a render of this stage, by name: nothing else does."""

    lobes: tuple[str, ...]
    lights: tuple[str, ...]
    strategies: tuple[str, ...]  # that can carry light here
    textures: dict[str, str]  # file, and which of its channels are read, like "rgb"
    attributes: tuple[str, ...]  # of a hit: "normals", "st", "tangents"
    aovs: tuple[str, ...]
    machinery: tuple[str, ...]


@dataclass(frozen=True)
class Memory:
    """Bytes held once a render stands ready; Embree takes more for a while as it builds."""

    source: int  # the stage's meshes as they were read; a last render lets go of them
    vertices: int
    acceleration: int
    lights: int
    textures_limit: int  # 0 without textures
    film: int


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
    requirements: Requirements
    memory: Memory | None
    memory_unknown: str | None  # why, if it is: the error that a render would end with
    unsupported: tuple[str, ...]

    def to_dict(self) -> dict[str, object]:
        """For JSON."""
        return asdict(self)


def inspect_contents(contents: StageContents) -> Inspection:
    """Looks at what was read, and gets a render with the stage's settings ready to measure it."""
    scene = contents.scene
    geometries = scene.geometries
    triangles = [_triangles(geometry) for geometry in geometries]
    groups = [sum(triangles[shape.geometry] for shape in group.shapes) for group in scene.groups]
    placed = Counter(instance.group for instance in scene.instances)
    files = {texture.file for texture in scene.textures}
    files |= {light.texture_file for light in scene.lights if light.texture_file}
    settings, memory, unknown = _core.RenderSettings(), None, None
    try:
        settings = render_settings(contents, None, {})
        memory = _memory(scene, settings, sum(map(_source_bytes, geometries)))
    except _core.Error as error:
        unknown = str(error)
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
        textures=tuple(sorted(files)),
        requirements=_requirements(scene, settings),
        memory=memory,
        memory_unknown=unknown,
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


# ---------------------------------------------------------------------------------------- memory


def _source_bytes(geometry: object) -> int:
    if not isinstance(geometry, _core.MeshDesc):
        return 0
    arrays = (
        geometry.points,
        geometry.face_vertex_counts,
        geometry.face_vertex_indices,
        geometry.normals,
        geometry.st,
        geometry.face_materials,
    )
    return sum(array.nbytes for array in arrays)


def _memory(scene: _core.SceneDescription, settings: _core.RenderSettings, source: int) -> Memory:
    use = _core.RenderSession(scene, settings).memory_use
    return Memory(
        source=source,
        vertices=use.vertices,
        acceleration=use.acceleration,
        lights=use.lights,
        textures_limit=use.textures_limit,
        film=use.film,
    )


# ---------------------------------------------------------------------------------- requirements


def _requirements(scene: _core.SceneDescription, settings: _core.RenderSettings) -> Requirements:
    needs = _core.find_requirements(scene, settings)
    used = set(needs.texture_coordinates)
    tangents = _core.CoordinateUse.Tangents in used
    attributes = {
        "normals": needs.normals,
        "st": tangents or _core.CoordinateUse.Lookup in used,
        "tangents": tangents,
    }
    return Requirements(
        lobes=_true(needs.lobes, _LOBES),
        lights=_true(needs.lights, LIGHTS),
        strategies=_true(needs.strategies, STRATEGIES),
        textures=_channels(scene, needs.textures),
        attributes=tuple(name for name, needed in attributes.items() if needed),
        aovs=tuple(_core.aov_name(aov) for aov in needs.aovs),
        machinery=_true(needs, _MACHINERY),
    )


def _true(holder: object, names: Iterable[str]) -> tuple[str, ...]:
    return tuple(name for name in names if getattr(holder, name))


def _channels(scene: _core.SceneDescription, read: list[list[bool]]) -> dict[str, str]:
    """By file; of several textures of one file, what any of them reads."""
    files: dict[str, set[str]] = {}
    for texture, channels in zip(scene.textures, read, strict=True):
        used = {name for name, on in zip("rgba", channels, strict=True) if on}
        if used:
            files.setdefault(texture.file, set()).update(used)
    for light in scene.lights:
        if light.texture_file:
            files.setdefault(light.texture_file, set()).update("rgb")
    return {
        file: "".join(name for name in "rgba" if name in used)
        for file, used in sorted(files.items())
    }
