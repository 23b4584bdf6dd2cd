"""What must hold of the schemas of our files."""

from __future__ import annotations

from typing import Any


def strict(schema: Any) -> Any:
    """What the schema does not describe is not allowed."""
    if isinstance(schema, dict):
        closed = {name: strict(part) for name, part in schema.items()}
        return closed | {"additionalProperties": False} if "required" in schema else closed
    return [strict(part) for part in schema] if isinstance(schema, list) else schema


def undescribed(schema: Any, place: str = "") -> list[str]:
    """Places of what has no description."""
    if not isinstance(schema, dict):
        return []
    inner = [
        (f"{place}.{name}", part)
        for group in ("properties", "$defs")
        for name, part in schema.get(group, {}).items()
    ]
    here = [name for name, part in inner if not ("description" in part or "$ref" in part)]
    return here + [missing for name, part in inner for missing in undescribed(part, name)]
