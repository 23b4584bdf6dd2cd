"""Pictures of the same scene by the same samples."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt
import OpenEXR

import etendue

Picture = npt.NDArray[np.float64]  # (h, w, 3)

# Matrices and apertures reach the renderer rounded otherwise, to single precision: a path may take
# another turn at an edge, here and there.
_DEPARTURE = 1e-3  # of a pixel's value, that of a thousandth of the mean in dark ones
_DEPARTING = 1e-3  # of the pixels
_MEAN = 1e-5


def read_color(file: Path) -> Picture:
    """Rgb of an .exr."""
    with OpenEXR.File(str(file)) as picture:
        channels = picture.channels()
        name = "RGBA" if "RGBA" in channels else "RGB"
        return np.asarray(channels[name].pixels[..., :3], dtype=np.float64)


def rgb(image: etendue.Image) -> Picture:
    """What we rendered ourselves."""
    return np.asarray(image.color[..., :3], dtype=np.float64)


def assert_same_picture(ours: Picture, reference: Picture) -> None:
    """The same seed gives the same samples, so two translations of a scene are the same when their
    pictures are, up to rounding: far stricter than any test of noise allows.
    """
    assert ours.shape == reference.shape
    scale = np.abs(reference) + 1e-3 * reference.mean()
    departing = (np.abs(ours - reference) > _DEPARTURE * scale).any(axis=-1)
    assert departing.mean() <= _DEPARTING, f"{departing.mean():.2%} of the pixels depart"
    # What departs is noise, and few; the mean must not show it.
    kept = ~departing
    assert abs(ours[kept].mean() / reference[kept].mean() - 1) <= _MEAN
