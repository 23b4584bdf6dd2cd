"""etendue.compare(a, b)."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np

from etendue.comparison.distance import flip_error, relative_squared_error
from etendue.comparison.exr import read_exr
from etendue.comparison.matching import check_lit, check_match
from etendue.comparison.picture import FloatArray, Picture
from etendue.comparison.ratio import Ratio, ratio_from_tiles, ratio_from_variances
from etendue.comparison.region import BoolArray, brightest_region
from etendue.comparison.sentence import sentence
from etendue.comparison.tiles import IntArray, tile_numbers, tile_sums

File = str | os.PathLike[str]


@dataclass(frozen=True)
class Distance:
    """Of a picture from another one that counts as right."""

    rel_mse: float
    """Mean of distance.relative_squared_error."""
    flip: float
    """Mean HDR-FLIP, 0..1."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """What compare() found. Arrays have row 0 on top."""

    a: Picture
    b: Picture
    reference: Picture | None
    whole: Ratio
    brightest: Ratio
    brightest_region: BoolArray
    """(h, w): where `brightest` was measured."""
    b_from_a: Distance
    a_from_reference: Distance | None
    b_from_reference: Distance | None
    ratio_map: FloatArray
    """(h, w): luminance of B over that of A, NaN where A has none."""
    z_scores: FloatArray | None
    """(h, w, 3): (B - A) over its standard error; None unless both files know their variance.

    0 where the pixels are equal, infinite where they differ and both claim to be exact. A variance
    that is itself estimated, from eight parts of the render as ours is, gives them longer tails
    than a normal distribution has.
    """

    @property
    def sentence(self) -> str:
        """The outcome in plain words."""
        return sentence(self.whole, self.brightest)


def compare(a: File, b: File, reference: File | None = None) -> Comparison:
    """Compares EXR files of one scene, by any renderers; A is what B is measured by.

    Intervals are at 95 %: from the variance channels when both files have them, else by the
    jackknife over tiles. The brightest region is a twentieth of the pixels, found in the reference
    if there is one, else in A and B together, each over its mean. Raises FileError for a file that
    cannot be used, ComparisonError for files that do not match, Error when the extra `report` is
    not installed.
    """
    first, second = read_exr(a), read_exr(b)
    target = None if reference is None else read_exr(reference)
    check_match(first, second)
    check_lit(first)
    check_lit(second)
    if target is not None:
        check_match(first, target)
        check_lit(target)
    tiles = tile_numbers(*first.luminance.shape)
    region = brightest_region(_guide(first, second, target))
    return Comparison(
        a=first,
        b=second,
        reference=target,
        whole=_ratio(first, second, tiles, np.ones_like(region)),
        brightest=_ratio(first, second, tiles, region),
        brightest_region=region,
        b_from_a=_distance(second, first),
        a_from_reference=None if target is None else _distance(first, target),
        b_from_reference=None if target is None else _distance(second, target),
        ratio_map=_ratio_map(first, second),
        z_scores=_z_scores(first, second),
    )


def _guide(a: Picture, b: Picture, reference: Picture | None) -> FloatArray:
    if reference is not None:
        return reference.luminance
    guide: FloatArray = a.luminance / a.luminance.mean() + b.luminance / b.luminance.mean()
    return guide


def _ratio(a: Picture, b: Picture, tiles: IntArray, region: BoolArray) -> Ratio:
    var_a, var_b = a.luminance_variance, b.luminance_variance
    in_a, in_b = a.luminance[region], b.luminance[region]
    if var_a is not None and var_b is not None:
        return ratio_from_variances(in_a, in_b, var_a[region], var_b[region])
    _, numbers = np.unique(tiles[region], return_inverse=True)
    return ratio_from_tiles(tile_sums(in_a, numbers), tile_sums(in_b, numbers), in_a.size)


def _distance(picture: Picture, target: Picture) -> Distance:
    relative = relative_squared_error(picture.color, target.color)
    return Distance(float(relative.mean()), flip_error(picture.color, target.color))


def _ratio_map(a: Picture, b: Picture) -> FloatArray:
    lit = a.luminance > 0
    ratios: FloatArray = np.full(lit.shape, np.nan)
    np.divide(b.luminance, a.luminance, out=ratios, where=lit)
    return ratios


def _z_scores(a: Picture, b: Picture) -> FloatArray | None:
    if a.variance is None or b.variance is None:
        return None
    difference = b.color - a.color
    error = np.sqrt(a.variance + b.variance)
    with np.errstate(divide="ignore", invalid="ignore"):
        scores: FloatArray = np.where(difference == 0, 0.0, difference / error)
    return scores
