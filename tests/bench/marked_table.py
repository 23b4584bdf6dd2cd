"""Documents whose tables are written by the program that measured them."""

from __future__ import annotations

from pathlib import Path


def replace_between_markers(document: Path, name: str, text: str) -> None:
    """Puts `text` between `<!-- name: begin -->` and `<!-- name: end -->`, which must be there."""
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    whole = document.read_text()
    before, found_begin, rest = whole.partition(begin)
    _, found_end, after = rest.partition(end)
    if not (found_begin and found_end):
        raise ValueError(f"{document} has no markers {begin} ... {end}")
    document.write_text(f"{before}{begin}\n{text}\n{end}{after}")
