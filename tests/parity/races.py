"""Who runs against whom."""

from __future__ import annotations

from dataclasses import dataclass

from parity.cases import BDPT, LUXCORE, MITSUBA_PATH, MITSUBA_PTRACER, OWN_STAGES, Case, own
from parity.tasks import Method, StageChoice

PATH = Method("etendue", "path")
LIGHT = Method("etendue", "light")


@dataclass(frozen=True)
class Runner:
    """A method, with samples per pixel for about a second of CPU."""

    method: Method
    spp: int


@dataclass(frozen=True)
class Race:
    """The first runner has to reach `bar` times the efficiency of the best of the others."""

    name: str
    case: Case
    reference: Method  #: no noisier than any runner at equal samples
    runners: tuple[Runner, ...]
    bar: float
    width: int

    @property
    def reference_spp(self) -> int:
        """So many that the reference's noise adds no more than a twelfth to anyone's relMSE."""
        return 12 * max(runner.spp for runner in self.runners)


def _case(stage: StageChoice, max_depth: int) -> Case:
    return Case(stage.file.stem, stage, max_depth, 0, ())


def _against_ourselves() -> tuple[Race, ...]:
    """bdpt against the best of path and light, on every stage."""
    return tuple(
        Race(
            f"bdpt among ours, {file.stem}",
            _case(StageChoice(file), 16),
            BDPT,
            (Runner(BDPT, 24), Runner(PATH, 96), Runner(LIGHT, 64)),
            0.5,
            64,
        )
        for file in sorted(OWN_STAGES.glob("*.usda"))
    )


RACES = (
    Race(
        "path",
        _case(own("cornell_box", "main"), 16),
        PATH,
        (Runner(PATH, 128), Runner(MITSUBA_PATH, 256)),
        1.0,
        96,
    ),
    Race(
        "light",
        _case(own("caustic_pool", "underwater"), 16),
        LIGHT,
        (Runner(LIGHT, 128), Runner(MITSUBA_PTRACER, 256)),
        1.0,
        96,
    ),
    Race(
        "bdpt, glass sphere",
        _case(own("glass_sphere", "main", tessellated=True), 12),
        BDPT,
        (Runner(BDPT, 40), Runner(LUXCORE, 40)),
        3.0,
        96,
    ),
    Race(
        "bdpt, lamp to the ceiling",
        _case(own("cornell_indirect", "main"), 16),
        BDPT,
        (Runner(BDPT, 32), Runner(LUXCORE, 12)),
        3.0,
        96,
    ),
    *_against_ourselves(),
)
