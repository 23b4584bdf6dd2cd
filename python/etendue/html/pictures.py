"""Scene-linear pictures as data URLs that a browser shows."""

from __future__ import annotations

import base64
import io
from typing import Any

import numpy as np

from etendue import _core
from etendue.arrays import Pixels
from etendue.extras import extra
from etendue.luminance import luminance

#: What the mean luminance becomes before the display transform: middle grey, ...
GREY = 0.18
#: ... unless the brightest hundredth, the caustic that the picture is about, then lay above this,
#: where the display transform leaves little difference between right and twice as bright.
HIGHLIGHT = 2.0


def common_exposure(*pictures: Pixels) -> float:
    """The factor that makes pictures (h, w, 3) of one scene comparable by eye."""
    luminances = np.concatenate([luminance(picture).ravel() for picture in pictures])
    mean, bright = float(luminances.mean()), float(np.percentile(luminances, 99))
    if mean <= 0:
        return 1.0
    return GREY / mean if bright <= 0 else min(GREY / mean, HIGHLIGHT / bright)


def picture_url(color: Pixels, exposure: float) -> str:
    """Of (h, w, 3), scene-linear Rec.709, through the default display and view.

    256 colours, dithered: noise does not compress, and a page of true-colour renders is three
    times the size without looking better.
    """
    display = _core.ColorConfig().apply((color * exposure).astype(np.float32))
    image = extra("PIL.Image")
    bytes_ = np.round(np.clip(display, 0, 1) * 255).astype(np.uint8)
    full = image.fromarray(bytes_)
    # Dithers only towards a palette that is given.
    return png_url(full.quantize(palette=full.quantize(256), dither=image.Dither.FLOYDSTEINBERG))


def png_url(image: Any) -> str:
    """Of a Pillow image."""
    buffer = io.BytesIO()
    image.save(buffer, format="png", optimize=True)
    return data_url("image/png", buffer.getvalue())


def data_url(kind: str, content: bytes) -> str:
    return f"data:{kind};base64,{base64.b64encode(content).decode('ascii')}"
