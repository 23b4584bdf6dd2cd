"""Predictions with what was measured, before a verdict."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol

from etendue.arrays import FloatArray
from etendue.validation.errors import Error, seen_by_ratio, seen_by_right
from etendue.validation.results import Check, Estimate
from etendue.validation.shots import Shot
from etendue.validation.statistics import Blocks, Samples

#: A true prediction is refused this often. The p-values come from the t distribution, whose far
#: tails noise with rare bright samples does not follow: no smaller rate would mean anything.
FALSE_ALARM = 1e-5


class Evidence(Protocol):
    """Measurements that can be held against a ratio."""

    def p_value(self, ratio: float) -> float: ...
    def estimate(self) -> Estimate: ...


@dataclass(frozen=True, eq=False)
class BlockEvidence:
    """A ratio that must hold all over a picture: what is shown is the block farthest from it."""

    blocks: Blocks
    predicted: float

    def p_value(self, ratio: float) -> float:
        return self.blocks.p_value(ratio)

    def estimate(self) -> Estimate:
        return self.blocks.worst(self.predicted).estimate()


@dataclass(frozen=True, eq=False)
class BlendEvidence:
    """A ratio whose prediction is itself measured: of right pictures, with their shares blended.

    All are (n,), of n independent renders; `blend` and `right` come from the same ones.
    """

    wrong: FloatArray
    right: FloatArray
    blend: FloatArray

    @property
    def predicted(self) -> float:
        return Samples(self.blend, self.right).ratio

    def p_value(self, ratio: float) -> float:
        return Samples(self.wrong, self.blend).p_value(ratio / self.predicted)

    def estimate(self) -> Estimate:
        return Samples(self.wrong, self.right).estimate()


@dataclass(frozen=True, eq=False)
class Claim:
    """One prediction and the evidence; `under` says what the evidence would show under errors."""

    name: str
    quantity: str
    shot: Shot
    formula: str
    predicted: float
    evidence: Evidence
    under: Mapping[Error, float] = field(default_factory=dict)

    def check(self) -> Check:
        """The verdict."""
        p_value = self.evidence.p_value(self.predicted)
        passed = p_value >= FALSE_ALARM
        return Check(
            name=self.name,
            quantity=self.quantity,
            stage=self.shot.described,
            camera=self.shot.camera,
            integrator=self.shot.integrator,
            corrections_off=self.shot.off,
            formula=self.formula,
            predicted=self.predicted,
            measured=self.evidence.estimate(),
            p_value=p_value,
            passed=passed,
            explanations=() if passed else self._explanations(),
        )

    def _explanations(self) -> tuple[str, ...]:
        return tuple(
            str(error)
            for error, ratio in self.under.items()
            if self.evidence.p_value(ratio) >= FALSE_ALARM
        )


def is_right(
    name: str,
    shot: Shot,
    evidence: Evidence,
    *,
    against: str,
    correction: str,
    wrong_ratio: float,
) -> Claim:
    """The corrected picture equals what it is held against.

    `wrong_ratio` is what leaving the correction out makes of it.
    """
    return Claim(
        name=f"{name}, right",
        quantity=f"right / {against}",
        shot=shot,
        formula="1",
        predicted=1.0,
        evidence=evidence,
        under=seen_by_right(correction, wrong_ratio),
    )


def is_wrong(
    name: str, shot: Shot, evidence: Evidence, *, formula: str, correction: str, ratio: float
) -> Claim:
    """Without the correction the picture of `shot` is off by the ratio."""
    return Claim(
        name=f"{name}, wrong",
        quantity="wrong / right",
        shot=shot.without(correction),
        formula=formula,
        predicted=ratio,
        evidence=evidence,
        under=seen_by_ratio(correction, ratio),
    )
