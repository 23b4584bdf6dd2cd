"""A Comparison as one HTML file that needs nothing else."""

from __future__ import annotations

import base64
import io
import os
from pathlib import Path
from typing import Any

import numpy as np

from etendue import _core
from etendue.comparison.comparison import Comparison
from etendue.comparison.extras import extra
from etendue.comparison.figures import figures
from etendue.comparison.picture import FloatArray, Picture
from etendue.exceptions import FileError

#: What the mean of A becomes before the display transform: middle grey.
GREY = 0.18
#: Factor at the ends of the ratio map's colour bar.
FULL_SCALE = 4.0


def write_page(found: Comparison, file: str | os.PathLike[str]) -> None:
    """Raises FileError when it cannot be written, Error when the extra `report` is missing."""
    jinja2 = extra("jinja2")
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(Path(__file__).parent),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
    )
    page = environment.get_template("page.html.j2").render(
        sentence=found.sentence, figures=figures(found), pictures=_pictures(found)
    )
    try:
        Path(file).write_text(page, encoding="utf-8")
    except OSError as error:
        raise FileError(f"{os.fspath(file)}: {error.strerror or error}") from error


def _pictures(found: Comparison) -> list[tuple[str, str]]:
    """Captions and data URLs. All pictures share A's exposure."""
    exposure = GREY / float(found.a.luminance.mean())
    shown = [("A", found.a), ("B", found.b)]
    if found.reference is not None:
        shown.append(("Reference", found.reference))
    urls = [
        (f"{name}: {Path(picture.file).name}", _picture_url(picture, exposure))
        for name, picture in shown
    ]
    urls.append(
        (
            "B / A, luminance. White: equal. Grey: A is black. Outlined: the brightest region.",
            _ratio_map_url(found),
        )
    )
    return urls


def _picture_url(picture: Picture, exposure: float) -> str:
    display = _core.ColorConfig().apply((picture.color * exposure).astype(np.float32))
    buffer = io.BytesIO()
    extra("matplotlib.image").imsave(buffer, np.clip(display, 0, 1), format="png")
    return _data_url(buffer)


def _ratio_map_url(found: Comparison) -> str:
    height, width = found.ratio_map.shape
    figure = extra("matplotlib.figure").Figure(
        figsize=(7, 1 + 6 * height / width), layout="constrained"
    )
    axes = figure.subplots()
    colors = extra("matplotlib").colormaps["RdBu_r"].with_extremes(bad="0.6")
    shown = axes.imshow(
        _log2(found.ratio_map),
        cmap=colors,
        vmin=-np.log2(FULL_SCALE),
        vmax=np.log2(FULL_SCALE),
        interpolation="nearest",
    )
    _outline(axes, found)
    axes.set_axis_off()
    ticks = [-2, -1, 0, 1, 2]
    bar = figure.colorbar(shown, ax=axes, ticks=ticks, extend="both")
    bar.ax.set_yticklabels([f"{2.0**tick:g} ×" for tick in ticks])
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=130)
    return _data_url(buffer)


def _log2(ratios: FloatArray) -> FloatArray:
    """A black or negative B, far below the bar's end, is shown as its end."""
    logs: FloatArray = np.log2(np.maximum(ratios, 1 / FULL_SCALE**2))
    return logs


def _outline(axes: Any, found: Comparison) -> None:
    if not found.brightest_region.all():
        axes.contour(found.brightest_region, levels=[0.5], colors="black", linewidths=0.8)


def _data_url(png: io.BytesIO) -> str:
    return "data:image/png;base64," + base64.b64encode(png.getvalue()).decode("ascii")
