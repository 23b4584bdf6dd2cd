"""Text into files."""

from __future__ import annotations

import os
from pathlib import Path

from etendue.exceptions import FileError


def write_text(file: str | os.PathLike[str], text: str) -> None:
    """As UTF-8, line ends as they are. Raises FileError, naming the file."""
    try:
        Path(file).write_text(text, encoding="utf-8", newline="")
    except OSError as error:
        raise FileError(f"{os.fspath(file)}: {error.strerror or error}") from error
