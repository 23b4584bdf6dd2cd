"""Which of a file's channels are the picture: renderers name them in several ways."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from etendue.exceptions import FileError

COLOR = ("R", "G", "B")
#: Luminance alone, shown as grey.
GREY = ("Y", "Y", "Y")
VARIANCE = "variance"
#: Last part of the name that a layer with everything in it has: of several, it is the picture.
WHOLE = ("rgba", "rgb", "beauty", "combined", "color", "c")


@dataclass(frozen=True)
class Source:
    """A channel and the part of the file that it is in."""

    part: Any
    channel: Any


def sources(parts: Iterable[Any]) -> dict[str, Source]:
    """By full name. Where there are several parts, a part's name goes before its channels', unless
    it is there already: both are usual."""
    parts = list(parts)
    found: dict[str, Source] = {}
    for part in parts:
        for name, channel in part.channels.items():
            found[_full_name(part, name, len(parts) > 1)] = Source(part, channel)
    return found


def _full_name(part: Any, name: str, several: bool) -> str:
    own = f"{part.name()}." if several else ""
    return name if name.startswith(own) else own + name


def choose_layer(file: str, names: Mapping[str, Source], wanted: str | None) -> str:
    """What stands before .R, .G, .B (or .Y) of the picture; empty for the plain channels.

    Raises FileError, saying what there is, when the wanted layer is missing, or when none is
    wanted and several could be meant.
    """
    layers = _layers(names)
    if wanted is not None:
        if wanted not in layers:
            raise FileError(f"{file}: has no layer '{wanted}' with R, G, B; {_listed(layers)}")
        return wanted
    likely = [layer for layer in layers if layer.split(".")[-1] != VARIANCE]
    if not likely:
        raise FileError(f"{file}: has no channels R, G, B; there are: {', '.join(names)}")
    whole = [layer for layer in likely if layer.split(".")[-1].lower() in WHOLE]
    for choice in ([layer for layer in likely if not layer], likely, whole):
        if len(choice) == 1:
            return choice[0]
    raise FileError(f"{file}: one layer must be chosen; {_listed(likely)}")


def color_channels(names: Mapping[str, Source], layer: str) -> tuple[str, ...] | None:
    """Full names; None when the layer has no colour."""
    for kind in (COLOR, GREY):
        full = tuple(f"{layer}.{name}" if layer else name for name in kind)
        if all(name in names for name in full):
            return full
    return None


def variance_channels(names: Mapping[str, Source], layer: str) -> tuple[str, ...] | None:
    """Full names; None when there is no variance of this layer's colour.

    A variance that names no layer is the whole picture's.
    """
    own = f"{layer}.{VARIANCE}"
    if layer and layer.split(".")[-1].lower() not in WHOLE:
        return color_channels(names, own)
    return color_channels(names, own) or color_channels(names, VARIANCE)


def _layers(names: Mapping[str, Source]) -> list[str]:
    before = dict.fromkeys(name.rpartition(".")[0] for name in names)
    return [layer for layer in before if color_channels(names, layer)]


def _listed(layers: list[str]) -> str:
    return f"there are: {', '.join(layer or 'the plain R, G, B' for layer in layers)}"
