"""Reports: a page, and the same figures for programs, in a folder of their own."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from etendue import _core
from etendue.exceptions import FileError
from etendue.extras import extra
from etendue.text_file import write_text

PAGE, JSON, CSV = "index.html", "results.json", "results.csv"
_PACKAGES = ("jinja2", "matplotlib", "PIL.Image")

Folder = str | os.PathLike[str]


def check_report(directory: Folder) -> None:
    """Raises now what write_files() would raise after the work. Makes the directory."""
    folder = _made(directory)
    for name in (PAGE, JSON, CSV):
        _core.check_writable(str(folder / name))
    for package in _PACKAGES:
        extra(package)


def write_files(
    directory: Folder,
    as_json: Callable[[], str],
    as_csv: Callable[[], str],
    as_html: Callable[[], str],
) -> Path:
    """The page to look at. The directory is made if there is none.

    The page comes last: what programs read is there even if a drawing fails. Raises FileError when
    something cannot be written, Error when the extra `report` is missing.
    """
    folder = _made(directory)
    write_text(folder / JSON, as_json())
    write_text(folder / CSV, as_csv())
    page = folder / PAGE
    write_text(page, as_html())
    return page


def _made(directory: Folder) -> Path:
    folder = Path(directory)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(f"{folder}: {error.strerror or error}") from error
    return folder
