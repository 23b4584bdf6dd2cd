"""What a renderer is asked to do, and what it hands back."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from parity.plain_scene import Floats, Scene


@dataclass(frozen=True)
class StageChoice:
    """A stage, and how it is changed before anybody reads it."""

    file: Path
    camera: str | None = None  #: prim path; default: the stage's
    lamp_radius: float | None = None  #: of all sphere and disk lights
    sky: Path | None = None  #: the image of all domes
    tessellated: bool = False  #: spheres become polyhedra, for renderers that know no other


@dataclass(frozen=True)
class Method:
    """A renderer and how it is to work."""

    renderer: str  #: etendue, mitsuba or luxcore
    integrator: str

    def __str__(self) -> str:
        return f"{self.renderer} {self.integrator}"


@dataclass(frozen=True)
class Task:
    """One picture, to be rendered any number of times."""

    method: Method
    stage: StageChoice | None  #: what Etendue reads
    scene: Scene | None  #: the same for the others
    width: int
    height: int
    max_depth: int  #: bounces; 0 shows emission only
    threads: int = 2


@dataclass(frozen=True)
class Picture:
    """A render and what it cost: start-up, loading and building not counted."""

    image: Floats  #: (h, w, 3), row 0 on top
    wall: float  #: seconds
    cpu: float  #: user seconds of all threads


class Renderer(Protocol):
    """A scene made ready."""

    def render(self, spp: int, seed: int) -> Picture:
        """Renders it once more, independently for every seed."""
