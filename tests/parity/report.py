"""Tables in Markdown files, between markers."""

from __future__ import annotations

import json
import platform
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

Row = Sequence[str]


def table(head: Row, rows: Iterable[Row]) -> str:
    """Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def replace(file: Path, name: str, text: str) -> None:
    """Puts text between `<!-- name -->` and `<!-- /name -->`. Raises ValueError without them."""
    opening, closing = f"<!-- {name} -->\n", f"<!-- /{name} -->"
    before, found, rest = file.read_text(encoding="utf-8").partition(opening)
    _, also_found, after = rest.partition(closing)
    if not (found and also_found):
        raise ValueError(f"{file}: no markers for '{name}'")
    file.write_text(f"{before}{opening}\n{text}\n\n{closing}{after}", encoding="utf-8")


class Results:
    """What was measured, kept from one run to the next so that a part can be done again."""

    def __init__(self, file: Path) -> None:
        self._file = file

    def put(self, name: str, value: Any) -> None:
        """Writes at once, beside what another run may have written meanwhile."""
        rows = {**self._rows(), name: value}
        self._file.parent.mkdir(parents=True, exist_ok=True)
        self._file.write_text(json.dumps(rows, indent=1), encoding="utf-8")

    def get(self, name: str) -> Any:
        """None when it has not been measured."""
        return self._rows().get(name)

    def _rows(self) -> dict[str, Any]:
        if not self._file.exists():
            return {}
        rows: dict[str, Any] = json.loads(self._file.read_text(encoding="utf-8"))
        return rows


def machine() -> str:
    """The processor, as Linux names it."""
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()
