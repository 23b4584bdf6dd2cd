"""The commonest pair of claims: right with a correction, wrong by a known ratio without it."""

from __future__ import annotations

from dataclasses import dataclass

from etendue.arrays import FloatArray
from etendue.validation.claims import BlockEvidence, Claim, is_right, is_wrong
from etendue.validation.pictures import blocks_of
from etendue.validation.results import Estimate
from etendue.validation.shots import Shot, Studio
from etendue.validation.statistics import Samples


@dataclass(frozen=True, eq=False)
class Pair:
    """Means (n,) of independent renders of a shot, with and without a correction."""

    name: str
    shot: Shot
    correction: str
    right: FloatArray
    wrong: FloatArray

    @property
    def measured(self) -> Estimate:
        """wrong / right"""
        return Samples(self.wrong, self.right).estimate()

    def claims(
        self, truth: FloatArray | float, against: str, formula: str, ratio: float
    ) -> list[Claim]:
        """That right equals the truth, and that wrong is `ratio` times right."""
        return [
            is_right(
                self.name,
                self.shot,
                Samples(self.right, truth),
                against=against,
                correction=self.correction,
                wrong_ratio=ratio,
            ),
            is_wrong(
                self.name,
                self.shot,
                Samples(self.wrong, self.right),
                formula=formula,
                correction=self.correction,
                ratio=ratio,
            ),
        ]


def measure(studio: Studio, shot: Shot, correction: str, spp: int, takes: int, name: str) -> Pair:
    """Renders both."""
    return Pair(
        name,
        shot,
        correction,
        studio.means(shot, spp, takes),
        studio.means(shot.without(correction), spp, takes),
    )


def same_picture(
    studio: Studio,
    shot: Shot,
    other: Shot,
    spp: tuple[int, int],
    takes: int,
    blocks: tuple[int, int],
    name: str,
) -> Claim:
    """That two integrators agree, in every one of rows x columns blocks."""
    measured, reference = studio.takes(shot, spp[0], takes), studio.takes(other, spp[1], takes)
    evidence = BlockEvidence(blocks_of(measured, reference, *blocks), 1.0)
    return Claim(
        name=f"{name}, {shot.integrator} and {other.integrator}, worst of "
        f"{len(evidence.blocks.blocks)} blocks",
        quantity=f"{shot.integrator} / {other.integrator}, both right",
        shot=shot,
        formula="1",
        predicted=1.0,
        evidence=evidence,
    )


def wrong_all_over(
    studio: Studio,
    shot: Shot,
    correction: str,
    spp: int,
    takes: int,
    blocks: tuple[int, int],
    name: str,
    formula: str,
    ratio: float,
) -> Claim:
    """That every block of the picture is off by the same ratio without the correction."""
    right = studio.takes(shot, spp, takes)
    wrong = studio.takes(shot.without(correction), spp, takes)
    evidence = BlockEvidence(blocks_of(wrong, right, *blocks), ratio)
    return is_wrong(
        f"{name}, worst of {len(evidence.blocks.blocks)} blocks",
        shot,
        evidence,
        formula=formula,
        correction=correction,
        ratio=ratio,
    )
