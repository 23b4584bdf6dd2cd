"""Who may include or import whom.

`violations(root)` reads the sources below `root` and names each line that points in a forbidden
direction.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

# What each room of core/src may include directly: itself, the façade, and everything that can be
# reached along these arrows.
ARROWS: dict[str, tuple[str, ...]] = {
    "session": ("integrator", "film", "io"),
    "integrator": ("scene", "film"),
    "scene": ("accel", "light", "camera", "bsdf"),
    "accel": ("texture", "geometry"),
    "light": ("texture", "geometry"),
    "camera": ("texture", "geometry"),
    "bsdf": ("texture", "geometry"),
    "texture": ("math",),
    "geometry": ("math",),
    "film": ("math",),
    "io": ("math",),
    "math": ("util",),
    "util": (),
}
# Arrows that others do not inherit: scene reaches io, what includes scene does not.
DIRECT_ONLY: dict[str, tuple[str, ...]] = {"scene": ("io",)}

# Which rooms may see a third party's headers, by the header's first directory.
THIRD_PARTIES: dict[str, tuple[str, ...]] = {
    "embree3": ("accel",),
    "embree4": ("accel",),
    "OpenImageIO": ("texture", "io"),
    "OpenColorIO": ("io",),
    "tbb": ("session",),
    "oneapi": ("session",),
    "pybind11": (),
    "pxr": (),
    "boost": (),
    "gtest": (),
}

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')
CXX_SUFFIXES = {".h", ".cpp"}


def _closure(room: str) -> frozenset[str]:
    reached = {room}
    waiting = [room]
    while waiting:
        for target in ARROWS[waiting.pop()]:
            if target not in reached:
                reached.add(target)
                waiting.append(target)
    return frozenset(reached).union(DIRECT_ONLY.get(room, ()))


ALLOWED: dict[str, frozenset[str]] = {room: _closure(room) for room in ARROWS}


def _includes(source: Path) -> Iterator[tuple[int, str]]:
    for number, line in enumerate(source.read_text(encoding="utf-8").splitlines(), start=1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1] or match[2]


def _cxx_sources(folder: Path) -> Iterator[Path]:
    return (path for path in sorted(folder.rglob("*")) if path.suffix in CXX_SUFFIXES)


def _core_complaint(room: str, place: PurePosixPath, header: str) -> str | None:
    """What is wrong with a source of `room`, at `place` below core/src, including `header`."""
    first = header.split("/", maxsplit=1)[0]
    if first in ARROWS and "/" in header:
        if first not in ALLOWED[room]:
            return f"{room} may not include {first}"
        if first == room == "integrator" and _crosses_integrators(place, PurePosixPath(header)):
            return "one integrator may not include another"
    elif first in THIRD_PARTIES and room not in THIRD_PARTIES[first]:
        return f"{room} may not include {first}"
    return None


def _crosses_integrators(place: PurePosixPath, header: PurePosixPath) -> bool:
    """Whether both lie in a folder below integrator/, and not in the same one."""
    return len(place.parts) > 2 and len(header.parts) > 2 and place.parts[1] != header.parts[1]


def _headers_showing_third_parties(base: Path) -> frozenset[str]:
    """The headers below core/src that bring in a third party, directly or by what they include."""
    includes = {
        source.relative_to(base).as_posix(): {header for _, header in _includes(source)}
        for source in _cxx_sources(base)
        if source.suffix == ".h"
    }
    showing: set[str] = set()
    while True:
        more = {
            name
            for name, headers in includes.items()
            if name not in showing
            and any(h in showing or h.split("/", maxsplit=1)[0] in THIRD_PARTIES for h in headers)
        }
        if not more:
            return frozenset(showing)
        showing |= more


def _check_core(root: Path) -> Iterator[str]:
    base = root / "core" / "src"
    showing = _headers_showing_third_parties(base)
    for source in _cxx_sources(base):
        place = PurePosixPath(source.relative_to(base).as_posix())
        room = place.parts[0]
        if room not in ARROWS:
            yield f"{source.relative_to(root)}: {room} is not a room"
            continue
        for number, header in _includes(source):
            complaint = _core_complaint(room, place, header)
            if complaint is None and header in showing and not header.startswith(f"{room}/"):
                complaint = f"{header} shows a third party, which only its own room may see"
            if complaint:
                yield f"{source.relative_to(root)}:{number}: {complaint}"


def _check_facade(root: Path) -> Iterator[str]:
    """The façade includes the standard library and itself."""
    for source in _cxx_sources(root / "core" / "include"):
        for number, header in _includes(source):
            if "/" in header and not header.startswith("etendue/"):
                yield f"{source.relative_to(root)}:{number}: the façade may not include {header}"


def _check_client(root: Path, folder: str, third_party: str, other: str) -> Iterator[str]:
    """A client of the façade includes its own files, its one third party and the façade."""
    base = root / folder
    for source in _cxx_sources(base):
        for number, header in _includes(source):
            parts = PurePosixPath(header).parts
            core = parts[0] in ARROWS and not _is_own(source, base, header)
            foreign = parts[0] in THIRD_PARTIES and parts[0] != third_party
            if core or foreign or ".." in parts or parts[0] == other:
                yield f"{source.relative_to(root)}:{number}: {folder} may not include {header}"


def _is_own(source: Path, base: Path, header: str) -> bool:
    return (source.parent / header).is_file() or (base / header).is_file()


def _imported_modules(source: Path) -> Iterator[tuple[int, str]]:
    for node in ast.walk(ast.parse(source.read_text(encoding="utf-8"), filename=str(source))):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node.lineno, alias.name
        elif isinstance(node, ast.ImportFrom) and node.module and node.level == 0:
            yield node.lineno, node.module


def _check_python(root: Path) -> Iterator[str]:
    """Only the stage reader knows USD's own Python."""
    package = root / "python" / "etendue"
    for source in sorted(package.rglob("*.py")):
        if source.is_relative_to(package / "usd_reader"):
            continue
        for number, module in _imported_modules(source):
            if module.split(".", maxsplit=1)[0] == "pxr":
                yield f"{source.relative_to(root)}:{number}: only usd_reader may import pxr"


def violations(root: Path) -> list[str]:
    """Every forbidden include and import of the tree at `root`."""
    return [
        *_check_core(root),
        *_check_facade(root),
        *_check_client(root, "python/bindings", third_party="pybind11", other="plugin"),
        *_check_client(root, "plugin", third_party="pxr", other="python"),
        *_check_python(root),
    ]
