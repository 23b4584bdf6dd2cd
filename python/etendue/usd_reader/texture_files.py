"""Files of textures, and the colour space that USD says they are in."""

from __future__ import annotations

import hashlib
from pathlib import Path

from pxr import Ar, Sdf, Usd, UsdShade

from etendue import _core
from etendue.usd_reader.colors import color_space_name
from etendue.usd_reader.context import ReadContext

# What an asset's colorSpace says, once aliases are resolved.
_FILE_COLOR_SPACES = {
    "srgb_rec709_scene": _core.TextureColorSpace.Srgb,
    "lin_rec709_scene": _core.TextureColorSpace.Raw,
    "raw": _core.TextureColorSpace.Raw,
    "data": _core.TextureColorSpace.Raw,
    "identity": _core.TextureColorSpace.Raw,
    "auto": _core.TextureColorSpace.Auto,
    "": _core.TextureColorSpace.Auto,
}


def file_color_space(
    context: ReadContext, path: Sdf.Path, attribute: Usd.Attribute
) -> _core.TextureColorSpace:
    """The colour space authored for the asset of `attribute`; `path` is whom to name."""
    name = color_space_name(attribute)
    if name not in _FILE_COLOR_SPACES:
        context.report.warn(
            f"texture color space {name}",
            path,
            f"texture colour space '{name}' is not supported; 'auto' is used",
        )
    return _FILE_COLOR_SPACES.get(name, _core.TextureColorSpace.Auto)


def texture_file(
    context: ReadContext,
    path: Sdf.Path,
    attribute: Usd.Attribute,
    asset: Sdf.AssetPath,
    stand_in: str,
) -> str | None:
    """The file of `asset` (`<UDIM>` stays in it), or None and a warning that names `stand_in`."""
    resolved = _resolve(asset, attribute)
    if not resolved:
        context.report.warn(
            f"missing texture {asset.path}",
            path,
            f"texture file '{asset.path}' is not found; {stand_in} is used",
        )
        return None
    if Ar.IsPackageRelativePath(resolved):
        return _extract(context, path, resolved, stand_in)
    return resolved


def _resolve(asset: Sdf.AssetPath, attribute: Usd.Attribute) -> str:
    """The resolved path. Empty when there is no such file."""
    if not UsdShade.UdimUtils.IsUdimIdentifier(asset.path):
        return str(asset.resolvedPath)
    for spec in attribute.GetPropertyStack(Usd.TimeCode.Default()):
        if spec.HasInfo("default") or spec.HasInfo("timeSamples"):
            return str(UsdShade.UdimUtils.ResolveUdimPath(asset.path, spec.layer))
    return ""


def _extract(context: ReadContext, path: Sdf.Path, resolved: str, stand_in: str) -> str | None:
    """Copies a texture out of its package (.usdz): image readers open plain files."""
    asset = Ar.GetResolver().OpenAsset(Ar.ResolvedPath(resolved))
    if asset is None:
        context.report.warn(
            f"missing texture {resolved}",
            path,
            f"texture file '{resolved}' cannot be read; {stand_in} is used",
        )
        return None
    inner = Ar.SplitPackageRelativePathInner(resolved)[1]
    digest = hashlib.sha256(resolved.encode()).hexdigest()[:16]
    file = context.scratch.directory / f"{digest}-{Path(inner).name}"
    if not file.exists():
        with asset:
            file.write_bytes(bytes(asset.GetBuffer()))
    return str(file)
