"""EXR files to pictures."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from pathlib import Path
from typing import Any

import numpy as np

from etendue.arrays import Pixels
from etendue.comparison.layers import (
    Source,
    choose_layer,
    color_channels,
    sources,
    variance_channels,
)
from etendue.comparison.picture import REC709_CHROMATICITIES, Picture
from etendue.exceptions import FileError
from etendue.extras import extra

_MAGIC = b"\x76\x2f\x31\x01"

Window = tuple[int, int, int, int]


def read_exr(file: str | os.PathLike[str], layer: str | None = None) -> Picture:
    """A layer's R, G, B, or its Y as grey, and the variance beside it (variance.R ...), if any.

    Without a layer's name: the plain channels, else the only layer, else the one named like a whole
    picture (layers.WHOLE). Raises FileError, naming the file, for what is missing, corrupt, without
    colour, or holds NaN, infinities or a negative variance. A variance that is infinite everywhere
    says that it is not known: renders of one pass have it so.
    """
    name = os.fspath(file)
    names = sources(_parts(name))
    chosen = choose_layer(name, names, layer)
    channels = color_channels(names, chosen)
    assert channels is not None  # a layer is chosen for having them
    part = names[channels[0]].part
    window = _window(part, "dataWindow")
    color = _planes(name, names, channels, window)
    _check_finite(name, channels, color, window)
    variance = _variance(name, names, variance_channels(names, chosen), window)
    chromaticities = part.header.get("chromaticities", REC709_CHROMATICITIES)
    return Picture(
        name,
        window,
        color,
        variance,
        chosen,
        tuple(map(float, chromaticities)),
        _window(part, "displayWindow"),
    )


def _parts(name: str) -> list[Any]:
    try:
        with Path(name).open("rb") as opened:
            magic = opened.read(len(_MAGIC))
    except OSError as error:
        raise FileError(f"{name}: {(error.strerror or str(error)).lower()}") from error
    if magic != _MAGIC:
        raise FileError(f"{name}: not an OpenEXR file")
    library = extra("OpenEXR")
    try:
        with _silent():
            parts = list(library.File(name, separate_channels=True).parts)
    except (RuntimeError, ValueError, TypeError) as error:
        raise FileError(f"{name}: cannot be read: {error}") from error
    # The library only warns of pixels that it cannot read, and leaves the part out.
    if not parts:
        raise FileError(f"{name}: corrupt: its pixels cannot be read")
    return parts


@contextmanager
def _silent() -> Iterator[None]:
    """The library prints its warnings, through Python and past it, to where results go; what they
    mean is said by an exception."""
    kept = os.dup(2)
    try:
        with Path(os.devnull).open("w") as nowhere, redirect_stdout(nowhere):
            os.dup2(nowhere.fileno(), 2)
            yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)


def _window(part: Any, name: str) -> Window:
    (x0, y0), (x1, y1) = part.header[name]
    return int(x0), int(y0), int(x1) + 1, int(y1) + 1


def _variance(
    file: str, names: dict[str, Source], channels: tuple[str, ...] | None, window: Window
) -> Pixels | None:
    if channels is None:
        return None
    variance = _planes(file, names, channels, window)
    if np.isposinf(variance).all():
        return None
    _check_finite(file, channels, variance, window)
    if variance.min() < 0:
        raise FileError(f"{file}: holds a negative variance")
    return variance


def _planes(
    file: str, names: dict[str, Source], channels: tuple[str, ...], window: Window
) -> Pixels:
    """(h, w, 3), 32-bit floats, which hold all that halves and floats do."""
    x0, y0, x1, y1 = window
    planes: Pixels = np.empty((y1 - y0, x1 - x0, len(channels)), np.float32)
    for index, name in enumerate(channels):
        plane = names[name].channel.pixels
        if plane.shape != planes.shape[:2] or plane.dtype.kind not in "fu":
            raise FileError(
                f"{file}: channel {name} does not hold one number a pixel (deep, subsampled?)"
            )
        planes[..., index] = plane
    return planes


def _check_finite(file: str, channels: tuple[str, ...], values: Pixels, window: Window) -> None:
    finite = np.isfinite(values)
    if finite.all():
        return
    y, x, channel = np.unravel_index(np.argmin(finite), finite.shape)
    bad = np.count_nonzero(~finite.all(axis=-1))
    raise FileError(
        f"{file}: channel {channels[channel]} is {values[y, x, channel]} in column "
        f"{x + window[0]}, row {y + window[1]} (from 0, row 0 on top); "
        f"not finite: {bad:,} of {finite[..., 0].size:,} pixels"
    )
