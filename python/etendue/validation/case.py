"""A case of the suite, before and after it has run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from etendue.validation.claims import Claim
from etendue.validation.effort import Effort
from etendue.validation.results import Cost, Figure
from etendue.validation.shots import Studio


@dataclass(frozen=True, eq=False)
class Outcome:
    """What a case found."""

    headline: str
    claims: tuple[Claim, ...] = ()
    figures: tuple[Figure, ...] = ()
    costs: tuple[Cost, ...] = ()


@dataclass(frozen=True)
class Case:
    """One lesson."""

    name: str
    title: str
    lesson: str
    """Paragraphs with empty lines between them."""
    run: Callable[[Studio, Effort], Outcome]

    @property
    def paragraphs(self) -> tuple[str, ...]:
        """Of the lesson, each on one line."""
        return tuple(" ".join(text.split()) for text in self.lesson.strip().split("\n\n"))
