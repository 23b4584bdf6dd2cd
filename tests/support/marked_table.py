"""Documents whose tables are written by the program that measured them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

Row = Sequence[str]


def table(head: Row, rows: Iterable[Row]) -> str:
    """Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def table_rows(text: str) -> list[Row]:
    """The rows of the table in a text; none where there is no table."""
    lines = [line for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line[1:-1].split("|")] for line in lines[2:]]


def between_markers(document: Path, name: str) -> str:
    """What stands between `<!-- name -->` and `<!-- /name -->`. Raises ValueError without them."""
    return _split(document, name)[1]


def replace_between_markers(document: Path, name: str, text: str) -> None:
    """Puts text there instead. Raises ValueError without the markers."""
    before, _, after = _split(document, name)
    document.write_text(f"{before}\n{text}\n\n{after}", encoding="utf-8")


def _split(document: Path, name: str) -> tuple[str, str, str]:
    """Up to the opening marker's end, between the two, from the closing one's start."""
    opening, closing = f"<!-- {name} -->\n", f"<!-- /{name} -->"
    before, found, rest = document.read_text(encoding="utf-8").partition(opening)
    between, also_found, after = rest.partition(closing)
    if not (found and also_found):
        raise ValueError(f"{document}: no markers for '{name}'")
    return before + found, between, also_found + after
