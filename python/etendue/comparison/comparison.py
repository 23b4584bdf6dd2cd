"""etendue.compare(a, b)."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from etendue.arrays import BoolArray, FloatArray, Pixels
from etendue.comparison.causes import INDICES, check_indices
from etendue.comparison.correlation import noise_correlation
from etendue.comparison.distance import Distance, distance
from etendue.comparison.exr import read_exr
from etendue.comparison.matching import check_lit, check_match
from etendue.comparison.picture import Picture
from etendue.comparison.ratio import Ratio, ratio_from_tiles, ratio_from_variances
from etendue.comparison.region import brightest_region
from etendue.comparison.sentence import sentence
from etendue.comparison.tiles import tile_numbers, tile_sums
from etendue.comparison.to_dict import to_dict
from etendue.luminance import quotient

File = str | os.PathLike[str]


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
    z_scores: Pixels | None
    """(h, w, 3): (B - A) over its standard error; None unless both files know their variance.

    0 where the pixels are equal, infinite where they differ and both claim to be exact. A variance
    that is itself estimated, from eight parts of the render as ours is, gives them longer tails
    than a normal distribution has.
    """
    indices: tuple[float, ...] = INDICES
    """Indices of refraction whose powers are named where they fit."""

    @property
    def identical(self) -> bool:
        """Every pixel of B is A's."""
        return np.array_equal(self.a.color, self.b.color)

    @property
    def sentence(self) -> str:
        """The outcome in plain words."""
        if self.identical:
            return "A and B are the same in every pixel."
        return sentence(self.whole, self.brightest, self.indices)

    def differs(self, tolerance: float) -> bool:
        """One of the two ratios is resolved to be more than so much from 1.

        What noise hides does not count as a difference.
        """
        return any(
            ratio.low > 1 + tolerance or ratio.high < 1 - tolerance
            for ratio in (self.whole, self.brightest)
        )

    def to_dict(self) -> dict[str, object]:
        """For JSON; to_dict.to_dict says what is in it."""
        return to_dict(self)


def compare(
    a: File,
    b: File,
    reference: File | None = None,
    *,
    layer: str | None = None,
    indices: Iterable[float] = INDICES,
    flip: bool | None = None,
) -> Comparison:
    """Compares EXR files of one scene, by any renderers; A is what B is measured by.

    layer: of all files, "Beauty" for Beauty.R, Beauty.G, Beauty.B; default: the plain channels, or
    the only layer, or the one that is named like a whole picture.
    indices: of refraction in the scene, whose powers are named where they explain a ratio.
    flip: whether to measure FLIP; default: up to distance.FLIP_PIXELS.

    Intervals are at 95 %: from the variance channels when both files have them, which must be of
    the pixels' means (not of their samples), else by the jackknife over tiles. The brightest region
    is a twentieth of the pixels, found in the reference if there is one, else in A and B together,
    each over its mean. Raises FileError for a file that cannot be used, ComparisonError for files
    that do not match, SettingsError for an index that cannot be, Error when the extra `report` is
    not installed.
    """
    checked = check_indices(indices)
    first, second = read_exr(a, layer), read_exr(b, layer)
    target = None if reference is None else read_exr(reference, layer)
    check_match(first, second)
    check_lit(first)
    check_lit(second)
    if target is not None:
        check_match(first, target)
        check_lit(target)
    region = brightest_region(_guide(first, second, target))
    whole, brightest = _ratios(first, second, region)
    return Comparison(
        a=first,
        b=second,
        reference=target,
        whole=whole,
        brightest=brightest,
        brightest_region=region,
        b_from_a=distance(second.color, first.color, flip),
        a_from_reference=None if target is None else distance(first.color, target.color, flip),
        b_from_reference=None if target is None else distance(second.color, target.color, flip),
        ratio_map=quotient(second.luminance, first.luminance),
        z_scores=_z_scores(first, second),
        indices=checked,
    )


def _guide(a: Picture, b: Picture, reference: Picture | None) -> FloatArray:
    if reference is not None:
        return reference.luminance
    guide: FloatArray = a.luminance / a.luminance.mean() + b.luminance / b.luminance.mean()
    return guide


def _ratios(a: Picture, b: Picture, region: BoolArray) -> tuple[Ratio, Ratio]:
    """Of the whole picture and of the region."""
    var_a, var_b = a.luminance_variance, b.luminance_variance
    everywhere = np.ones_like(region)
    if var_a is None or var_b is None:
        return _from_tiles(a, b, everywhere), _from_tiles(a, b, region)
    correlation = noise_correlation(a.luminance, b.luminance, var_a, var_b)
    whole, brightest = (
        ratio_from_variances(
            a.luminance[where], b.luminance[where], var_a[where], var_b[where], correlation
        )
        for where in (everywhere, region)
    )
    return whole, brightest


def _from_tiles(a: Picture, b: Picture, region: BoolArray) -> Ratio:
    _, numbers = np.unique(tile_numbers(*region.shape)[region], return_inverse=True)
    in_a, in_b = a.luminance[region], b.luminance[region]
    return ratio_from_tiles(tile_sums(in_a, numbers), tile_sums(in_b, numbers), in_a.size)


def _z_scores(a: Picture, b: Picture) -> Pixels | None:
    if a.variance is None or b.variance is None:
        return None
    difference = b.color - a.color
    with np.errstate(divide="ignore", invalid="ignore"):
        scores: Pixels = difference / np.sqrt(a.variance + b.variance)
    scores[difference == 0] = 0
    return scores
