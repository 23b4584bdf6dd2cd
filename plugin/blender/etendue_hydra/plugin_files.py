"""Where the render delegate is, and making USD know it."""

from __future__ import annotations

import os
from pathlib import Path

import bpy

VARIABLE = "ETENDUE_HYDRA_PLUGIN"
_BUNDLED = Path(__file__).resolve().parent / "usd" / "hdEtendue" / "resources"


class PluginMissingError(RuntimeError):
    """There is no render delegate to load."""


def resources() -> Path:
    """The directory of the delegate's plugInfo.json. Raises PluginMissingError."""
    place = Path(os.environ.get(VARIABLE, _BUNDLED)).resolve()
    if not (place / "plugInfo.json").is_file():
        raise PluginMissingError(
            f"Etendue: no plugInfo.json in {place}; the extension was packaged without the render "
            f"delegate, or {VARIABLE} names a wrong directory"
        )
    return place


def register_delegate() -> None:
    """Makes the delegate known to the USD that Blender brings."""
    bpy.utils.expose_bundled_modules()
    from pxr import Plug

    # A relative path would be taken from wherever Blender was started.
    Plug.Registry().RegisterPlugins(str(resources()))
