"""Radiance pictures, for tests and stages that need an image of more than eight bits."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt


def write_hdr(file: Path, image: npt.ArrayLike) -> None:
    """Writes (h, w, 3), row 0 on top; uncompressed, eight bits of the brightest channel kept."""
    rgb = np.asarray(image, dtype=np.float64)
    brightest = rgb.max(axis=2)
    exponent = np.where(brightest > 0, np.frexp(brightest)[1], 0)
    mantissas = np.minimum(np.rint(rgb * np.exp2(8.0 - exponent)[..., np.newaxis]), 255)
    rgbe = np.concatenate([mantissas, (exponent + 128)[..., np.newaxis]], axis=2)
    height, width = brightest.shape
    header = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(header.encode() + rgbe.astype(np.uint8).tobytes())
