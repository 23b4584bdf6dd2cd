"""Colour values to linear Rec.709, by the colour space that USD says they are in."""

from __future__ import annotations

from collections.abc import Iterable

from pxr import Gf, Usd

from etendue.usd_reader.context import ReadContext

Rgb = tuple[float, float, float]

RENDERING_SPACE = "lin_rec709_scene"

# MaterialX and older USD files name the same spaces differently.
_ALIASES = {
    "lin_rec709": RENDERING_SPACE,
    "lin_srgb": RENDERING_SPACE,
    "linear": RENDERING_SPACE,
    "sRGB": "srgb_rec709_scene",
    "srgb_texture": "srgb_rec709_scene",
    "acescg": "lin_ap1_scene",
    "lin_ap1": "lin_ap1_scene",
    "lin_ap0": "lin_ap0_scene",
    "lin_rec2020": "lin_rec2020_scene",
    "lin_displayp3": "lin_p3d65_scene",
    "srgb_displayp3": "srgb_p3d65_scene",
    "lin_adobergb": "lin_adobergb_scene",
    "g18_rec709": "g18_rec709_scene",
    "g22_rec709": "g22_rec709_scene",
    "g22_ap1": "g22_ap1_scene",
    "adobergb": "g22_adobergb_scene",
}
_DATA = frozenset({"", "data", "raw", "identity", "auto", RENDERING_SPACE})


def color_space_name(attribute: Usd.Attribute) -> str:
    """The space authored on the attribute, or on its prim or an ancestor; empty when none is."""
    name = str(Usd.ColorSpaceAPI.ComputeColorSpaceName(attribute, None) or "")
    return _ALIASES.get(name, name)


def to_rendering_space(context: ReadContext, attribute: Usd.Attribute, rgb: Iterable[float]) -> Rgb:
    """`rgb` in linear Rec.709. An unknown space is warned about and taken as linear Rec.709."""
    red, green, blue = (float(channel) for channel in rgb)
    name = color_space_name(attribute)
    if name in _DATA:
        return red, green, blue
    space = _color_space(attribute.GetPrim(), name)
    if space is None:
        context.report.warn(
            f"color space {name}",
            attribute.GetPath(),
            f"unknown colour space '{name}'; the colour is taken as linear Rec.709",
        )
        return red, green, blue
    converted = Gf.ColorSpace(RENDERING_SPACE).Convert(space, Gf.Vec3f(red, green, blue)).GetRGB()
    return float(converted[0]), float(converted[1]), float(converted[2])


def _color_space(prim: Usd.Prim, name: str) -> Gf.ColorSpace | None:
    if Gf.ColorSpace.IsValid(name):
        return Gf.ColorSpace(name)
    # A custom space: ColorSpaceDefinitionAPI on the prim or an ancestor.
    if Usd.ColorSpaceAPI.IsValidColorSpaceName(prim, name, None):
        return Usd.ColorSpaceAPI.ComputeColorSpace(prim, name, None)
    return None
