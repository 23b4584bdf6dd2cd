"""Packages the extension as Blender's command does, installs the package and enables it.

blender_extension.py SOURCE FOLDER

The package goes to FOLDER; Blender's own folder is what BLENDER_USER_RESOURCES says. Prints where
the extension takes the render delegate from.
"""

from __future__ import annotations

import importlib
import os
import subprocess
import sys
from pathlib import Path

import bpy

# In Blender itself: blender --command extension.
COMMAND = Path(bpy.utils.system_resource("SCRIPTS"), "addons_core/bl_pkg/cli/blender_ext.py")


def command(*arguments: str) -> None:
    """Ends the script when the command fails."""
    subprocess.run([sys.executable, str(COMMAND), *arguments], check=True, stdout=sys.stderr)


def main(source: Path, folder: Path) -> None:
    """See the module."""
    del os.environ["ETENDUE_HYDRA_PLUGIN"]  # the extension has its own
    command("validate", str(source))
    command("build", "--source-dir", str(source), "--output-dir", str(folder))
    (package,) = folder.glob("*.zip")
    bpy.ops.extensions.package_install_files(
        filepath=str(package), repo="user_default", enable_on_install=True
    )
    if not hasattr(bpy.types.Scene, "etendue"):
        sys.exit("the extension is not enabled")
    plugin_files = importlib.import_module("bl_ext.user_default.etendue_hydra.plugin_files")
    print(plugin_files.resources())


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
