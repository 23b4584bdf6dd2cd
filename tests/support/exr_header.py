"""The header of an OpenEXR file, read without a library."""

from __future__ import annotations

import struct
from pathlib import Path

_MAGIC = 20000630


def read_exr_header(file: Path) -> dict[str, object]:
    """Attributes by name: strings, boxes as (x0, y0, x1, y1), "channels" as a list of names.

    Attributes of other types are left as bytes.
    """
    data = file.read_bytes()
    (magic,) = struct.unpack_from("<i", data)
    if magic != _MAGIC:
        raise ValueError(f"{file}: not an OpenEXR file")
    attributes: dict[str, object] = {}
    position = 8
    while data[position]:
        name, position = _string(data, position)
        kind, position = _string(data, position)
        (size,) = struct.unpack_from("<i", data, position)
        value = data[position + 4 : position + 4 + size]
        position += 4 + size
        attributes[name] = _decoded(kind, value)
    return attributes


def _decoded(kind: str, value: bytes) -> object:
    if kind == "string":
        return value.decode()
    if kind == "box2i":
        return struct.unpack("<4i", value)
    if kind == "chlist":
        names = []
        position = 0
        while value[position]:
            name, position = _string(value, position)
            names.append(name)
            position += 16
        return names
    return value


def _string(data: bytes, position: int) -> tuple[str, int]:
    end = data.index(0, position)
    return data[position:end].decode(), end + 1
