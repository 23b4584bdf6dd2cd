"""EXR files as other renderers write them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt
import OpenEXR


def write_channels(file: Path, channels: dict[str, npt.NDArray[np.generic]]) -> Path:
    """Planes (h, w) by name."""
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    with OpenEXR.File(header, channels) as written:
        written.write(str(file))
    return file


def write_color(file: Path, color: npt.ArrayLike, variance: npt.ArrayLike | None = None) -> Path:
    """Arrays (h, w, 3) as 32-bit floats."""
    channels = _planes("", np.asarray(color))
    if variance is not None:
        channels |= _planes("variance.", np.asarray(variance))
    return write_channels(file, channels)


def _planes(prefix: str, values: npt.NDArray[np.generic]) -> dict[str, npt.NDArray[np.generic]]:
    return {
        f"{prefix}{name}": np.ascontiguousarray(values[..., index], dtype=np.float32)
        for index, name in enumerate("RGB")
    }
