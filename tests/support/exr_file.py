"""EXR files as other renderers write them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import numpy.typing as npt
import OpenEXR

Plane = npt.NDArray[np.generic]


def write_channels(file: Path, channels: Mapping[str, Plane], **attributes: object) -> Path:
    """Planes (h, w) by name, in one part."""
    return write_parts(file, {"": channels}, **attributes)


def write_parts(file: Path, parts: Mapping[str, Mapping[str, Plane]], **attributes: object) -> Path:
    """Channels by the parts' names, each part with the same attributes."""
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage} | attributes
    made = [OpenEXR.Part(dict(header), dict(planes), name) for name, planes in parts.items()]
    with OpenEXR.File(made) as written:
        written.write(str(file))
    return file


def write_color(file: Path, color: npt.ArrayLike, variance: npt.ArrayLike | None = None) -> Path:
    """Arrays (h, w, 3) as 32-bit floats."""
    channels = _planes("", np.asarray(color))
    if variance is not None:
        channels |= _planes("variance.", np.asarray(variance))
    return write_channels(file, channels)


def _planes(prefix: str, values: Plane) -> dict[str, Plane]:
    return {
        f"{prefix}{name}": np.ascontiguousarray(values[..., index], dtype=np.float32)
        for index, name in enumerate("RGB")
    }
