"""Runs a script of this folder with the host's USD and the render delegate registered.

python -m plugin.host SCRIPT ARGUMENTS...
"""

from __future__ import annotations

import os
import runpy
import sys

import bpy


def main() -> None:
    """`pxr` can be imported only after the first line."""
    bpy.utils.expose_bundled_modules()
    from pxr import Plug

    Plug.Registry().RegisterPlugins(os.environ["ETENDUE_HYDRA_PLUGIN"])
    del sys.argv[0]
    runpy.run_module(f"plugin.host.{sys.argv[0]}", run_name="__main__")


if __name__ == "__main__":
    main()
