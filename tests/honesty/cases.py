"""What is rendered to see whether claimed errors are true."""

from __future__ import annotations

from dataclasses import dataclass

from etendue.settings import RenderOptions

#: The mean ratio of actual over claimed relMSE has to be in here.
BAR = (0.8, 1.25)
#: The reference's error over the smallest target: a sixteenth of the relMSE, which is subtracted.
REFERENCE_PART = 0.25


@dataclass(frozen=True)
class Case:
    stage: str
    integrator: str
    targets: tuple[float, ...]

    @property
    def reference_error(self) -> float:
        return REFERENCE_PART * min(self.targets)

    def options(self, error: float) -> RenderOptions:
        return RenderOptions(
            resolution=(48, 36), integrator=self.integrator, error=error, spp=1 << 14
        )

    def reference_options(self) -> RenderOptions:
        return {**self.options(self.reference_error), "spp": 1 << 20}


CASES = (
    Case("caustic_pool", "bdpt", (0.2, 0.1)),
    Case("cornell_box", "path", (0.2, 0.1)),
    Case("cornell_indirect", "bdpt", (0.2, 0.1)),
    Case("bump_sphere", "bdpt", (0.1, 0.05)),
    Case("glass_sphere", "bdpt", (0.2,)),
)
