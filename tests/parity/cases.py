"""What is compared with what."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from parity.make_task import make_task
from parity.tasks import Method, StageChoice, Task

OWN_STAGES = Path(__file__).parents[2] / "stages"
PARITY_STAGES = Path(__file__).parent / "stages"
SKY = Path(__file__).parents[2] / "build" / "parity" / "sky.hdr"  #: made by write_sky()

BDPT = Method("etendue", "bdpt")
MITSUBA_PATH = Method("mitsuba", "path")
MITSUBA_PTRACER = Method("mitsuba", "ptracer")
LUXCORE = Method("luxcore", "BIDIRCPU")


def own(
    name: str, camera: str, lamp_radius: float | None = None, tessellated: bool = False
) -> StageChoice:
    """A stage of this repository."""
    return StageChoice(
        OWN_STAGES / f"{name}.usda",
        f"/cameras/{camera}",
        lamp_radius=lamp_radius,
        tessellated=tessellated,
    )


def parity(name: str, sky: Path | None = None, tessellated: bool = False) -> StageChoice:
    """A stage of this check's own."""
    file = PARITY_STAGES / f"{name}.usda"
    return StageChoice(file, "/cameras/main", sky=sky, tessellated=tessellated)


@dataclass(frozen=True)
class Peer:
    """Another renderer, with the samples per pixel that resolve a half per cent."""

    method: Method
    spp: int


@dataclass(frozen=True)
class Case:
    """A stage, our bdpt, and those that must show the same."""

    name: str
    stage: StageChoice
    max_depth: int
    spp: int
    peers: tuple[Peer, ...]

    def task(self, method: Method, width: int) -> Task:
        """The picture for one renderer."""
        return make_task(self.stage, method, width, self.max_depth)


# Depths: LuxCore counts otherwise (see luxcore_renderer), so its cases are deep enough for what is
# left out not to matter. Where only chance finds the lamp behind glass, the lamp is made larger.
# Glass has a skewed noise, which few samples make look smaller than it is.
CASES = (
    Case(
        "Cornell box",
        own("cornell_box", "main"),
        16,
        32,
        (Peer(MITSUBA_PATH, 512), Peer(MITSUBA_PTRACER, 192), Peer(LUXCORE, 32)),
    ),
    Case(
        "lamp to the ceiling",
        own("cornell_indirect", "main"),
        24,
        32,
        (Peer(MITSUBA_PATH, 1024), Peer(MITSUBA_PTRACER, 192), Peer(LUXCORE, 24)),
    ),
    Case(
        "glass sphere",
        own("glass_sphere", "main", lamp_radius=0.4),
        12,
        192,
        (Peer(MITSUBA_PATH, 2048),),
    ),
    Case(
        "glass sphere of triangles",
        own("glass_sphere", "main", lamp_radius=0.4, tessellated=True),
        12,
        192,
        (Peer(LUXCORE, 320),),
    ),
    Case(
        "pool from under water",
        own("caustic_pool", "underwater"),
        20,
        320,
        (Peer(MITSUBA_PTRACER, 3072),),
    ),
    Case(
        "pool from under water, large lamp",
        own("caustic_pool", "underwater", lamp_radius=1.0),
        20,
        160,
        (Peer(LUXCORE, 256),),
    ),
    Case(
        "flat pool from under water, large lamp",
        own("flat_pool", "underwater", lamp_radius=1.0),
        20,
        192,
        (Peer(MITSUBA_PTRACER, 1024), Peer(LUXCORE, 160)),
    ),
    Case(
        "smooth normals",
        parity("smooth_sphere"),
        8,
        32,
        (Peer(MITSUBA_PATH, 512), Peer(MITSUBA_PTRACER, 3072), Peer(LUXCORE, 96)),
    ),
    Case(
        "rough glass sphere",
        parity("rough_glass_sphere"),
        12,
        96,
        (Peer(MITSUBA_PATH, 768), Peer(MITSUBA_PTRACER, 4096)),
    ),
    Case(
        "latlong sky",
        parity("latlong_sky", sky=SKY, tessellated=True),
        8,
        32,
        (Peer(MITSUBA_PATH, 256), Peer(LUXCORE, 64)),
    ),
)
