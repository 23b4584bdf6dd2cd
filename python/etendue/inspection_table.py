"""An Inspection for people."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from etendue.inspection import Inspection, Requirements


def inspection_table(inspection: Inspection) -> RenderableType:
    """A table of what the stage holds and needs, then the list of what is not supported."""
    table = Table(title=f"{inspection.source}, frame {inspection.frame:g}", show_header=False)
    table.add_column(style="bold")
    table.add_column(overflow="fold")
    for name, value in _rows(inspection):
        table.add_row(name, Text(value))
    if not inspection.unsupported:
        return table
    notes = [Text(f"  {line}", overflow="fold") for line in inspection.unsupported]
    return Group(table, Text("Not supported or not usable:"), *notes)


def _rows(inspection: Inspection) -> list[tuple[str, str]]:
    settings = inspection.render_settings or "none"
    if inspection.resolution:
        settings += f" ({inspection.resolution[0]}x{inspection.resolution[1]})"
    return [
        ("prims", _list(inspection.prims)),
        ("cameras", "\n".join(inspection.cameras) or "none"),
        ("render settings", settings),
        ("geometries", _list(inspection.geometries)),
        ("triangles", f"{inspection.triangles:,} ({inspection.instanced_triangles:,} placed)"),
        ("instances", f"{inspection.instances:,}"),
        ("lights", _list(inspection.lights)),
        ("materials", _list(inspection.materials)),
        ("textures", "\n".join(inspection.textures) or "none"),
        *_needs(inspection.requirements),
        ("memory", _memory(inspection)),
    ]


def _needs(requirements: Requirements) -> list[tuple[str, str]]:
    rows = []
    for part, names in asdict(requirements).items():
        if part == "textures":
            names = [f"{file} ({channels})" for file, channels in names.items()]
        words = ", ".join(name if part == "textures" else name.replace("_", " ") for name in names)
        rows.append((f"needed {part}", words or "none"))
    return rows


def _memory(inspection: Inspection) -> str:
    memory = inspection.memory
    if memory is None:
        return f"unknown: {inspection.memory_unknown}"
    parts = {
        "meshes as read": memory.source,
        "vertex data": memory.vertices,
        "BVH": memory.acceleration,
        "lights": memory.lights,
        "film": memory.film,
    }
    lines = [f"{name}: {_mebibytes(size)}" for name, size in parts.items()]
    if memory.textures_limit:
        lines.append(f"textures: at most {_mebibytes(memory.textures_limit)}")
    return "\n".join(lines)


def _mebibytes(size: int) -> str:
    return f"{size / 2**20:,.2f} MiB"


def _list(counts: Mapping[str, int]) -> str:
    return ", ".join(f"{count:,} {name or 'untyped'}" for name, count in counts.items()) or "none"
