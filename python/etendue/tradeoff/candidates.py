"""Ways to render that are worth comparing."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from etendue.exceptions import SettingsError
from etendue.settings import RenderOptions

#: Options that `etendue render` has, too.
_FLAGS = {"integrator": "--integrator", "max_depth": "--max-depth", "light_paths": "--light-paths"}

_LEAVES_OUT = "It leaves out what takes more bounces, as it was told to."
_CHANCE = (
    "A path from the camera meets a lamp behind smooth glass, water or mirrors only by chance: "
    "rarely where the lamp is small, never where it is a point."
)


@dataclass(frozen=True)
class Candidate:
    """A point on the dial."""

    name: str
    """As --only takes it."""
    turned: str
    """Which of the dial's knobs differs from the default: "max depth"."""
    what: str
    """In plain words, a sentence without its end."""
    options: RenderOptions
    """Of Stage.render(), without samples, size and seed."""
    if_short: str
    """What explains it where light is missing."""
    complete: bool = False
    """It samples all that the default samples, so it has no floor unless something is broken."""

    @property
    def asked_for(self) -> str:
        """How to render so: options of the command, else keywords of Stage.render()."""
        flags = [(_FLAGS.get(key), value) for key, value in self.options.items()]
        if all(flag for flag, _ in flags):
            return " ".join(f"{flag} {_told(value)}" for flag, value in flags) or "the default"
        keywords = ", ".join(f"{key}={value!r}" for key, value in self.options.items())
        return f"stage.render({keywords})"


DEFAULT = "bdpt"

CANDIDATES = (
    Candidate(
        "path",
        "integrator",
        "Paths from the camera, joined to the lamps at every surface",
        {"integrator": "path"},
        _CHANCE,
    ),
    Candidate(
        "path-depth-4",
        "max depth",
        "Paths from the camera of at most 4 bounces",
        {"integrator": "path", "max_depth": 4},
        f"{_LEAVES_OUT} {_CHANCE}",
    ),
    Candidate(
        "light",
        "integrator",
        "Paths from the lamps, joined to the camera",
        {"integrator": "light"},
        "A path from a lamp cannot meet the camera by chance, so whatever is seen directly on a "
        "lamp, or in or through a smooth mirror, glass or water, stays dark.",
    ),
    Candidate(
        DEFAULT,
        "integrator",
        "The default: paths from both ends, joined in every way, each way weighted by how well it "
        "does",
        {},
        "It can find all light that has any other way than smooth glass or mirrors at both ends.",
        complete=True,
    ),
    Candidate(
        "bdpt-balance",
        "weights",
        "The default with the balance heuristic in place of the power heuristic",
        {"heuristic": "balance"},
        "Weights change noise, not the mean: light must not be missing.",
        complete=True,
    ),
    Candidate(
        "bdpt-no-connections",
        "strategies",
        "Paths from both ends, but those from the lamps are joined to the camera only",
        {"strategies": ("emission_hit", "direct_light", "light_image")},
        "Light that only a join of both paths midway finds is missing.",
    ),
    Candidate(
        "bdpt-no-light-image",
        "strategies",
        "Paths from both ends, without joining those from the lamps to the camera",
        {"strategies": ("emission_hit", "direct_light", "connection")},
        "Caustics on what the camera sees directly are what the strategy left out is for. "
        + _CHANCE,
    ),
    Candidate(
        "bdpt-light-paths-1",
        "light paths",
        "The default with 1 path from the lamps for each from the camera",
        {"light_paths": 1.0},
        "Numbers of paths change noise, not the mean: light must not be missing.",
        complete=True,
    ),
    Candidate(
        "bdpt-light-paths-8",
        "light paths",
        "The default with 8 paths from the lamps for each from the camera",
        {"light_paths": 8.0},
        "Numbers of paths change noise, not the mean: light must not be missing.",
        complete=True,
    ),
    Candidate(
        "bdpt-depth-4",
        "max depth",
        "The default with at most 4 bounces",
        {"max_depth": 4},
        _LEAVES_OUT,
    ),
    Candidate(
        "bdpt-depth-8",
        "max depth",
        "The default with at most 8 bounces",
        {"max_depth": 8},
        _LEAVES_OUT,
    ),
    Candidate(
        "bdpt-roulette-2",
        "roulette",
        "The default, but dim paths may be ended at random from the second bounce on",
        {"roulette_depth": 2},
        "Roulette changes noise, not the mean: light must not be missing.",
        complete=True,
    ),
    Candidate(
        "bdpt-no-roulette",
        "roulette",
        "The default, but no path is ended at random",
        {"roulette_depth": -1},
        "Roulette changes noise, not the mean: light must not be missing.",
        complete=True,
    ),
)


def candidate_names() -> tuple[str, ...]:
    """In the order they run."""
    return tuple(candidate.name for candidate in CANDIDATES)


def chosen_candidates(names: Iterable[str] | None) -> tuple[Candidate, ...]:
    """By name, default all. Raises SettingsError for an unknown name, and for no name at all."""
    if names is None:
        return CANDIDATES
    wanted = list(names)
    if not wanted:
        raise SettingsError("no candidate is named; there is nothing to measure")
    for name in wanted:
        if name not in candidate_names():
            known = ", ".join(candidate_names())
            raise SettingsError(f"unknown candidate '{name}'; there are: {known}")
    return tuple(candidate for candidate in CANDIDATES if candidate.name in wanted)


def _told(value: object) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)
