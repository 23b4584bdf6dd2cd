"""What auto is held against, and on what."""

from __future__ import annotations

from dataclasses import dataclass, replace

from etendue._core import ChosenMethod, IntegratorKind
from etendue.tradeoff.candidates import CANDIDATES, Candidate

#: Auto may cost this much more than the best fixed choice, its pilot included.
BAR = 1.15
#: Renders of so many seconds of one core: with more cores they are longer, and the pilot's part is
#: smaller.
SECONDS = 20.0


@dataclass(frozen=True)
class View:
    stage: str
    camera: str | None = None
    """None: the stage's."""

    @property
    def name(self) -> str:
        return self.stage if self.camera is None else f"{self.stage}, {self.camera}"


VIEWS = (
    View("bump_plane"),
    View("bump_sphere"),
    View("caustic_pool"),
    View("caustic_pool", "above"),
    View("caustic_pool", "surface"),
    View("cornell_box"),
    View("cornell_indirect"),
    View("crossings"),
    View("facet"),
    View("flat_pool"),
    View("furnace"),
    View("glass_sphere"),
    View("phong"),
    View("sundial"),
)

_BY_NAME = {candidate.name: candidate for candidate in CANDIDATES}


def _with_light_paths(count: float) -> Candidate:
    like = _BY_NAME["bdpt-light-paths-8"]
    return replace(like, name=f"bdpt-light-paths-{count:g}", options={"light_paths": count})


#: Integrators, subsets of strategies, and numbers of light paths. Of the last, the default is one:
#: 4 where there are caustics, else 0.5.
FIXED = (
    *(_BY_NAME[name] for name in ("path", "light", "bdpt-no-connections", "bdpt-no-light-image")),
    *(_with_light_paths(count) for count in (0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0)),
)


def candidate_of(chosen: ChosenMethod) -> str:
    """Which of FIXED auto chose."""
    if chosen.integrator == IntegratorKind.Path:
        return "path"
    return f"bdpt-light-paths-{chosen.light_paths_per_pixel:g}"
