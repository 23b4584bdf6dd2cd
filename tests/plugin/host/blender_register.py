"""Registers and unregisters the add-on twice, as users do who switch it off and on."""

from __future__ import annotations

import bpy

from plugin.host.blender_add_on import etendue_hydra

_ENGINE = etendue_hydra.engine.EtendueRenderEngine


def traces() -> list[bool]:
    """Of the add-on, in Blender."""
    panels = bpy.types.Panel.__subclasses__()
    foreign = [panel for panel in panels if not panel.__module__.startswith("etendue_hydra")]
    return [
        hasattr(bpy.types.Scene, "etendue"),
        hasattr(bpy.types, "RENDER_PT_etendue_sampling"),
        any(_ENGINE.bl_idname in getattr(panel, "COMPAT_ENGINES", ()) for panel in foreign),
        bool(_ENGINE.is_registered),
    ]


def main() -> None:
    """Prints what there is of it: before, and after every step."""
    print(traces())
    for _ in range(2):
        etendue_hydra.register()
        print(traces())
        etendue_hydra.unregister()
        print(traces())


if __name__ == "__main__":
    main()
