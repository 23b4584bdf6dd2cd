"""What a stage asks for and Etendue does not do, told once per kind."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class StageWarning:
    """One kind of thing that was left out or replaced, with the first prim that asked for it."""

    kind: str
    path: str
    message: str
    count: int = 1

    def __str__(self) -> str:
        more = f" (and {self.count - 1} more)" if self.count > 1 else ""
        return f"{self.path}: {self.message}{more}"


class Report:
    """Collects warnings while a stage is read. A kind is told once, however many the prims."""

    def __init__(self) -> None:
        self._first: dict[str, tuple[str, str]] = {}
        self._paths: dict[str, set[str]] = {}

    def warn(self, kind: str, path: object, message: str) -> None:
        """Notes that `path` asks for `kind`; `message` is kept for the first path only."""
        self._first.setdefault(kind, (str(path), message))
        self._paths.setdefault(kind, set()).add(str(path))

    @property
    def warnings(self) -> tuple[StageWarning, ...]:
        """One entry per kind, in the order in which they were met."""
        return tuple(
            StageWarning(kind, path, message, len(self._paths[kind]))
            for kind, (path, message) in self._first.items()
        )
