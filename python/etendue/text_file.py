"""Text into files."""

from __future__ import annotations

import os
from pathlib import Path

from etendue.exceptions import FileError


def write_text(file: str | os.PathLike[str], text: str) -> None:
    """As UTF-8, line ends as they are, in place of what was there once all is written.

    What is no character, in the name of a file say, becomes "?". Raises FileError, naming the file.
    """
    target = Path(os.path.realpath(file))
    part = target.with_name(f".{target.name}.part")
    try:
        try:
            part.write_bytes(text.encode("utf-8", errors="replace"))
            part.replace(target)
        finally:
            part.unlink(missing_ok=True)
    except OSError as error:
        raise FileError(f"{os.fspath(file)}: {error.strerror or error}") from error
