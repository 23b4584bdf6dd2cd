"""EXR files to pictures."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from etendue.comparison.picture import FloatArray, Picture
from etendue.exceptions import FileError
from etendue.extras import extra

COLOR = ("R", "G", "B")
VARIANCE = ("variance.R", "variance.G", "variance.B")

_MAGIC = b"\x76\x2f\x31\x01"


def read_exr(file: str | os.PathLike[str]) -> Picture:
    """The first part's R, G, B and, where all three exist, variance.R, variance.G, variance.B.

    Raises FileError, naming the file, for what is missing, corrupt, without colour, or holds NaN,
    infinities or a negative variance. A variance that is infinite everywhere says that it is not
    known: renders of one pass have it so.
    """
    name = os.fspath(file)
    part = _first_part(name)
    window = _data_window(part)
    channels = part.channels
    missing = [channel for channel in COLOR if channel not in channels]
    if missing:
        raise FileError(
            f"{name}: has no channel {', '.join(missing)}; there are: {', '.join(channels)}"
        )
    color = _planes(name, channels, COLOR, window)
    _check_finite(name, COLOR, color)
    return Picture(name, window, color, _variance(name, channels, window))


def _first_part(name: str) -> Any:
    try:
        with Path(name).open("rb") as opened:
            magic = opened.read(len(_MAGIC))
    except OSError as error:
        raise FileError(f"{name}: {(error.strerror or str(error)).lower()}") from error
    if magic != _MAGIC:
        raise FileError(f"{name}: not an OpenEXR file")
    try:
        parts = extra("OpenEXR").File(name, separate_channels=True).parts
    except (RuntimeError, ValueError, TypeError) as error:
        raise FileError(f"{name}: cannot be read: {error}") from error
    # The library only warns of pixels that it cannot read, and leaves the part out.
    if not parts:
        raise FileError(f"{name}: corrupt: its pixels cannot be read")
    return parts[0]


def _data_window(part: Any) -> tuple[int, int, int, int]:
    (x0, y0), (x1, y1) = part.header["dataWindow"]
    return int(x0), int(y0), int(x1) + 1, int(y1) + 1


def _variance(
    name: str, channels: dict[str, Any], window: tuple[int, int, int, int]
) -> FloatArray | None:
    if any(channel not in channels for channel in VARIANCE):
        return None
    variance = _planes(name, channels, VARIANCE, window)
    if np.isposinf(variance).all():
        return None
    _check_finite(name, VARIANCE, variance)
    if variance.min() < 0:
        raise FileError(f"{name}: holds a negative variance")
    return variance


def _planes(
    name: str,
    channels: dict[str, Any],
    wanted: tuple[str, ...],
    window: tuple[int, int, int, int],
) -> FloatArray:
    x0, y0, x1, y1 = window
    planes = [channels[channel].pixels for channel in wanted]
    for channel, plane in zip(wanted, planes, strict=True):
        # Deep pixels are lists, and subsampled channels are smaller.
        if plane.shape != (y1 - y0, x1 - x0) or plane.dtype.kind not in "fu":
            raise FileError(f"{name}: channel {channel} does not hold one number a pixel")
    return np.stack(planes, axis=-1).astype(np.float64)


def _check_finite(name: str, channels: tuple[str, ...], values: FloatArray) -> None:
    bad = ~np.isfinite(values)
    if not bad.any():
        return
    y, x, channel = (int(index[0]) for index in np.nonzero(bad))
    raise FileError(
        f"{name}: channel {channels[channel]} is {values[y, x, channel]} in column {x}, row {y}; "
        f"{np.count_nonzero(bad.any(axis=-1))} pixels are not finite"
    )
