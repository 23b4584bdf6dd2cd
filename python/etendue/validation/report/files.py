"""index.html, results.json and results.csv."""

from __future__ import annotations

import os
from pathlib import Path

from etendue import _core
from etendue.exceptions import FileError
from etendue.extras import extra
from etendue.text_file import write_text
from etendue.validation.report.csv_file import as_csv
from etendue.validation.report.json_file import as_json
from etendue.validation.report.page import as_html
from etendue.validation.results import ValidationResult

PAGE, JSON, CSV = "index.html", "results.json", "results.csv"
_PACKAGES = ("jinja2", "matplotlib", "PIL.Image")


def check_report(directory: str | os.PathLike[str]) -> None:
    """Raises now what write_report() would raise after the work. Makes the directory."""
    folder = _made(directory)
    for name in (PAGE, JSON, CSV):
        _core.check_writable(str(folder / name))
    for package in _PACKAGES:
        extra(package)


def write_report(result: ValidationResult, directory: str | os.PathLike[str]) -> Path:
    """The page to look at. The directory is made if there is none.

    Raises FileError when something cannot be written, Error when the extra `report` is missing.
    """
    folder = _made(directory)
    write_text(folder / JSON, as_json(result))
    write_text(folder / CSV, as_csv(result))
    page = folder / PAGE
    write_text(page, as_html(result))
    return page


def _made(directory: str | os.PathLike[str]) -> Path:
    folder = Path(directory)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(f"{folder}: {error.strerror or error}") from error
    return folder
