"""Whether two renderers show the same picture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np
from scipy import stats

from parity.plain_scene import Floats

BLOCK = 8  #: pixels
#: Chance that two right renderers are told apart by the blocks of one comparison, or by its means.
FALSE_ALARM = 1e-5
#: Largest difference of the means, and the largest standard error that it is believed with.
MEAN_TOLERANCE = 0.005
MEAN_RESOLUTION = 0.0015
#: Least standard deviation of one render's block, relative. Renderers interpolate textures and
#: build round lamps each in its own way; an empty sky has no noise that this could hide in.
LEAST_SCATTER = 0.001


Verdict: TypeAlias = Literal["agrees", "differs", "unresolved"]


@dataclass(frozen=True)
class Comparison:
    """Of renders of one picture by two renderers, every render with a seed of its own."""

    ratio: float  #: of the mean radiances, the other's over ours
    ratio_error: float  #: its standard error
    mean_p: float  #: of Welch's t-test on the means
    block_rms: float  #: root mean square difference of the blocks, relative to the mean radiance
    expected_rms: float  #: what noise alone makes of that
    worst_z: float  #: of all blocks and channels
    block_p: float  #: the smallest over blocks and channels, Bonferroni-corrected

    @property
    def verdict(self) -> Verdict:
        """Unresolved: the noise of the means is too large for their agreement to say much.

        A difference that is certain counts however small it is.
        """
        if min(self.mean_p, self.block_p) <= FALSE_ALARM:
            return "differs"
        if self.ratio_error > MEAN_RESOLUTION:
            return "unresolved"
        return "agrees" if abs(self.ratio - 1) <= MEAN_TOLERANCE else "differs"


def compare(ours: Floats, other: Floats) -> Comparison:
    """Of two stacks (n, h, w, 3)."""
    mean, other_mean = ours.mean((1, 2, 3)), other.mean((1, 2, 3))
    ratio = other_mean.mean() / mean.mean()
    error = np.hypot(stats.sem(mean) / mean.mean(), stats.sem(other_mean) / other_mean.mean())
    a, b = _blocks(ours), _blocks(other)
    difference = b.mean(0) - a.mean(0)
    noise = np.hypot(_standard_error(a), _standard_error(b))
    seen = noise > 0  # others are black to both
    p = 2 * stats.t.sf(np.abs(difference[seen] / noise[seen]), _freedom(a, b)[seen])
    return Comparison(
        ratio=float(ratio),
        ratio_error=float(ratio * error),
        mean_p=float(stats.ttest_ind(mean, other_mean, equal_var=False).pvalue),
        block_rms=float(np.sqrt((difference**2).mean()) / mean.mean()),
        expected_rms=float(np.sqrt((noise**2).mean()) / mean.mean()),
        worst_z=float(np.abs(difference[seen] / noise[seen]).max()),
        block_p=min(1.0, float(p.min()) * p.size),
    )


def _standard_error(blocks: Floats) -> Floats:
    """Of the means."""
    scatter = np.maximum(blocks.std(axis=0, ddof=1), LEAST_SCATTER * np.abs(blocks.mean(axis=0)))
    error: Floats = scatter / np.sqrt(len(blocks))
    return error


def _freedom(a: Floats, b: Floats) -> Floats:
    """Welch's degrees of freedom."""
    u, v = _standard_error(a) ** 2, _standard_error(b) ** 2
    pooled: Floats = (u + v) ** 2 / (
        u**2 / (len(a) - 1) + v**2 / (len(b) - 1) + np.finfo(float).tiny
    )
    return pooled


def _blocks(stack: Floats) -> Floats:
    """Means over blocks, (n, rows, columns, 3)."""
    count, height, width, channels = stack.shape
    if height % BLOCK or width % BLOCK:
        raise ValueError(f"{width} x {height} is not a whole number of blocks")
    rows = stack.reshape(count, height // BLOCK, BLOCK, width // BLOCK, BLOCK, channels)
    means: Floats = rows.mean(axis=(2, 4))
    return means
