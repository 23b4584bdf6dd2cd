"""The lessons of the suite."""

from etendue.validation.case import Case
from etendue.validation.cases import (
    caustic_pool,
    cost,
    facets,
    flat_water,
    mis_blend,
    phong,
    rough_water,
    smooth_shading,
    two_crossings,
)

CASES: tuple[Case, ...] = (
    flat_water.CASE,
    caustic_pool.CASE,
    two_crossings.CASE,
    rough_water.CASE,
    facets.CASE,
    smooth_shading.CASE,
    phong.CASE,
    mis_blend.CASE,
    cost.CASE,
)
