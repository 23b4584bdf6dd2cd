"""index.html, results.json and results.csv."""

from __future__ import annotations

import os
from pathlib import Path

from etendue.exceptions import FileError
from etendue.text_file import write_text
from etendue.validation.report.csv_file import as_csv
from etendue.validation.report.json_file import as_json
from etendue.validation.report.page import as_html
from etendue.validation.results import ValidationResult


def make_directory(directory: str | os.PathLike[str]) -> Path:
    """With its parents, if it is not there. Raises FileError."""
    folder = Path(directory)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(f"{folder}: {error.strerror or error}") from error
    return folder


def write_report(result: ValidationResult, directory: str | os.PathLike[str]) -> Path:
    """The page to look at. The directory is made if there is none.

    Raises FileError when something cannot be written, Error when the extra `report` is missing.
    """
    folder = make_directory(directory)
    write_text(folder / "results.json", as_json(result))
    write_text(folder / "results.csv", as_csv(result))
    page = folder / "index.html"
    write_text(page, as_html(result))
    return page
