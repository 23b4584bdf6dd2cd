"""A Comparison as one HTML file that needs nothing else."""

from __future__ import annotations

import os
from pathlib import Path

from etendue.arrays import BoolArray
from etendue.comparison.comparison import Comparison
from etendue.comparison.figures import figures
from etendue.html import common_exposure, legend, picture_url, ratio_map_url, rendered
from etendue.text_file import write_text

#: Factor at the ends of the ratio map's colour bar.
FULL_SCALE = 4.0

_TEMPLATE = Path(__file__).parent / "page.html.j2"


def write_page(found: Comparison, file: str | os.PathLike[str]) -> None:
    """Raises FileError when it cannot be written, Error when the extra `report` is missing."""
    values = {
        "sentence": found.sentence,
        "figures": figures(found),
        "pictures": _pictures(found),
        "ratio_map": ratio_map_url(found.ratio_map, FULL_SCALE, _outlined(found)),
        "legend": legend(FULL_SCALE),
    }
    write_text(file, rendered(_TEMPLATE, values))


def _pictures(found: Comparison) -> list[tuple[str, str]]:
    """Captions and data URLs. All pictures share one exposure."""
    exposure = common_exposure(found.a.color, found.b.color)
    shown = [("A", found.a), ("B", found.b)]
    if found.reference is not None:
        shown.append(("Reference", found.reference))
    return [
        (f"{name}: {Path(picture.file).name}", picture_url(picture.color, exposure))
        for name, picture in shown
    ]


def _outlined(found: Comparison) -> BoolArray | None:
    return None if found.brightest_region.all() else found.brightest_region
