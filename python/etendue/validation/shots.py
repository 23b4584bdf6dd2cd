"""What to render, and renders of it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from functools import lru_cache
from hashlib import blake2b
from pathlib import Path

import numpy as np

from etendue._core import CameraDesc
from etendue.arrays import FloatArray
from etendue.exceptions import FileError
from etendue.image import Image
from etendue.luminance import luminance
from etendue.settings import ADJOINT, RenderOptions
from etendue.stage import Stage
from etendue.usd_reader import read_stage
from etendue.usd_reader.edited import open_edited

Values = Mapping[str, object]


@dataclass(frozen=True)
class Shot:
    """One view of one stage by one integrator. Everything but the samples is set."""

    stage: str
    """File name in stages/."""
    camera: str
    integrator: str
    resolution: tuple[int, int]
    max_depth: int = 16
    variants: Values = field(default_factory=dict)
    """Choices by "/prim{set}"."""
    values: Values = field(default_factory=dict)
    """Attributes by "/prim.attribute"."""
    off: tuple[str, ...] = ()
    """Adjoint corrections that are left out."""
    crop: tuple[int, int, int, int] | None = None
    strategy_images: int = 0
    aovs: tuple[str, ...] = ()
    light_paths: float | None = None
    threads: int = field(default=0, repr=False)
    """0: all. No part of what the shot is: it changes nothing in the picture."""

    def without(self, *corrections: str) -> Shot:
        """The same shot, wrong on purpose."""
        return replace(self, off=corrections)

    def by(self, integrator: str) -> Shot:
        """The same shot by another integrator. Path tracing has no strategies (s, t)."""
        images = 0 if integrator == "path" else self.strategy_images
        return replace(self, integrator=integrator, strategy_images=images)

    @property
    def described(self) -> str:
        """The stage with what was changed in it."""
        changes = [f"{_last(place)}={choice}" for place, choice in self.variants.items()]
        changes += [f"{_last(place)}={_short(value)}" for place, value in self.values.items()]
        return f"{self.stage} ({', '.join(changes)})" if changes else self.stage


Renderer = Callable[[Shot, int, int], Image]
"""(shot, spp, seed): renders it. Tests put in their own."""


def render(shot: Shot, spp: int, seed: int) -> Image:
    """Raises what etendue.open() and Stage.render() raise."""
    options = RenderOptions(
        resolution=shot.resolution,
        crop=shot.crop,
        spp=spp,
        seed=seed,
        integrator=shot.integrator,
        max_depth=shot.max_depth,
        strategy_images=shot.strategy_images,
        aovs=shot.aovs,
        light_paths=shot.light_paths,
        threads=shot.threads,
        adjoint=[name for name in ADJOINT if name not in shot.off],
    )
    return _stage_of(shot).render(shot.camera, **options)


@dataclass
class Studio:
    """Renders shots with seeds of their own, and counts."""

    seed: int
    renderer: Renderer = render
    renders: int = 0
    paths: int = 0
    _takes: dict[str, FloatArray] = field(default_factory=dict)

    def image(self, shot: Shot, spp: int, take: int = 0) -> Image:
        """Shots that differ in the corrections alone have the same seed for the same take."""
        seed = self._seed(replace(shot, off=()), spp, f"image {take}")
        return self._counted(self.renderer(shot, spp, seed))

    def first_hits(self, shot: Shot) -> Image:
        """Normal and depth of one sample a pixel, at the same points whatever the stage's values.

        Shots of one stage and camera that differ in what is authored have the same seed.
        """
        seen = replace(shot.by("path"), max_depth=0, aovs=("normal", "depth"))
        seed = self._seed(replace(seen, values={}), 1, "first hits")
        return self._counted(self.renderer(seen, 1, seed))

    def images(self, shot: Shot, spp: int, count: int, name: str = "") -> Iterator[Image]:
        """Independent renders; other names are other renders.

        Several at a time, on one thread each: they are small. The pictures are the same.
        """
        seeds = [self._seed(shot, spp, f"take {name} {take}") for take in range(count)]
        alone = replace(shot, threads=1)
        with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
            for image in pool.map(lambda seed: self.renderer(alone, spp, seed), seeds):
                yield self._counted(image)

    def takes(self, shot: Shot, spp: int, count: int, name: str = "") -> FloatArray:
        """(n, h, w): luminance of independent renders, which are made once."""
        key = f"{shot!r} {spp} {count} {name}"
        if key not in self._takes:
            images = self.images(shot, spp, count, name)
            self._takes[key] = np.stack([luminance(image.color) for image in images])
        return self._takes[key]

    def means(self, shot: Shot, spp: int, count: int, name: str = "") -> FloatArray:
        """(n,): mean luminance of independent renders."""
        means: FloatArray = self.takes(shot, spp, count, name).mean(axis=(1, 2))
        return means

    def _seed(self, shot: Shot, spp: int, purpose: str) -> int:
        key = f"{self.seed} {shot!r} {spp} {purpose}".encode()
        return int.from_bytes(blake2b(key, digest_size=7).digest(), "little")

    def _counted(self, image: Image) -> Image:
        self.renders += 1
        self.paths += image.statistics.camera_paths + image.statistics.light_paths
        return image


def camera_of(shot: Shot) -> CameraDesc:
    """As the core gets it."""
    stage = _stage_of(shot)
    return stage.scene.cameras[stage.cameras.index(shot.camera)]


def stages_folder() -> Path:
    """Where the stages are: beside the installed package, or in the source tree."""
    package = Path(__file__).parents[1]
    for folder in (package / "stages", package.parents[1] / "stages"):
        if folder.is_dir():
            return folder
    raise FileError(f"{package / 'stages'}: the stages are not installed")


def _stage_of(shot: Shot) -> Stage:
    return _open(shot.stage, tuple(shot.variants.items()), tuple(shot.values.items()))


Key = tuple[tuple[str, object], ...]


# A case renders the same few stages many times over.
@lru_cache(maxsize=8)
def _open(stage: str, variants: Key, values: Key) -> Stage:
    choices = {place: str(choice) for place, choice in variants}
    return Stage(read_stage(open_edited(stages_folder() / stage, choices, dict(values))))


def _last(place: str) -> str:
    """'/World{crossing}' to 'crossing', '/A/B.inputs:specular_ior' to 'B.specular_ior'."""
    prim, _, name = place.rstrip("}").replace("{", "{.").partition(".")
    last = name.rsplit(":", 1)[-1]
    return last if prim.endswith("{") else f"{prim.rsplit('/', 1)[-1]}.{last}"


def _short(value: object) -> str:
    if isinstance(value, int | float):
        return f"{value:g}"
    if isinstance(value, tuple):
        # Of an array the first value speaks for all.
        return f"({', '.join(_short(x) for x in value)})" if _flat(value) else _short(value[0])
    return "none" if value is None else str(value)


def _flat(values: tuple[object, ...]) -> bool:
    return not any(isinstance(value, tuple) for value in values)
