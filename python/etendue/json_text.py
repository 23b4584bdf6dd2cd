"""Documents for programs, as JSON."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from math import isfinite


def json_text(document: Mapping[str, object]) -> str:
    return json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def finite(value: float) -> float | None:
    """JSON knows no infinity and no NaN: what noise hides is null."""
    return float(value) if isfinite(value) else None


def all_finite(values: Iterable[float]) -> list[float | None]:
    return [finite(value) for value in values]
