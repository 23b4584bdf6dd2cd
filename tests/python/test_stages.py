"""Path, light and bidirectional tracing agree on the stages of this repository.

Where an integrator cannot see all of a stage, the test says what it looks at instead. Light tracing
sees nothing that a camera sees directly through or in a smooth surface, so it is held to the rest
of the picture. Path tracing finds a small lamp behind a smooth surface too rarely for any
statistics, so that stage's lamp is made larger first.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import pytest
from pxr import Usd, UsdLux

import etendue
from etendue.settings import RenderOptions
from support.pictures import FALSE_ALARM, compare, replicas

STAGES = Path(__file__).parents[2] / "stages"
REPLICAS = 16

Window = tuple[int, int, int, int]


@dataclass(frozen=True)
class Case:
    """One comparison of an integrator with bdpt."""

    stage: str
    integrator: Literal["path", "light"]
    spp: int
    lamp_radius: float | None = None
    crop: Window | None = None  #: pixels of a 16 x 12 image
    resolution: float = 0.02  #: what the means must at least be resolved to

    def __str__(self) -> str:
        return f"{self.stage}-{self.integrator}"


CASES = [
    Case("cornell_box", "path", 64),
    Case("cornell_box", "light", 64),
    Case("sundial", "path", 64),
    Case("sundial", "light", 64),
    Case("cornell_indirect", "path", 256),
    Case("cornell_indirect", "light", 64),
    Case("bump_plane", "path", 32),
    Case("bump_plane", "light", 128),
    Case("bump_sphere", "path", 32),
    Case("bump_sphere", "light", 256),
    Case("furnace", "path", 32),
    Case("phong", "path", 32),
    Case("phong", "light", 128),
    Case("crossings", "light", 128),
    Case("facet", "path", 32),
    Case("facet", "light", 128),
    Case("glass_sphere", "path", 256, lamp_radius=0.4),
    Case("glass_sphere", "light", 1024, crop=(0, 8, 16, 12)),
    Case("flat_pool", "path", 256, lamp_radius=0.8),
    Case("flat_pool", "light", 128),
    Case("caustic_pool", "path", 256, lamp_radius=0.8),
    Case("caustic_pool", "light", 128),
]


def open_stage(case: Case) -> etendue.Stage:
    stage = Usd.Stage.Open(str(STAGES / f"{case.stage}.usda"))
    if case.lamp_radius is not None:
        with Usd.EditContext(stage, stage.GetSessionLayer()):
            for prim in stage.Traverse():
                if prim.IsA(UsdLux.SphereLight) or prim.IsA(UsdLux.DiskLight):
                    prim.GetAttribute("inputs:radius").Set(case.lamp_radius)
    return etendue.open(stage)


@pytest.mark.parametrize("case", CASES, ids=str)
def test_integrators_agree(case: Case) -> None:
    stage = open_stage(case)
    options: RenderOptions = {"resolution": (16, 12), "max_depth": 10, "aovs": ("color",)}
    if case.crop is not None:
        options["crop"] = case.crop
    other = replicas(
        stage, REPLICAS, 0, {**options, "integrator": case.integrator, "spp": case.spp}
    )
    bdpt = replicas(stage, REPLICAS, 1000, {**options, "integrator": "bdpt", "spp": 64})
    result = compare(other, bdpt)
    assert result.p > FALSE_ALARM, str(result)
    assert result.resolution < case.resolution, str(result)


def test_every_stage_is_compared() -> None:
    assert {case.stage for case in CASES} == {file.stem for file in STAGES.glob("*.usda")}
