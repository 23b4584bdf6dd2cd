"""Etendue as a render engine of Blender's, through its Hydra render delegate."""

from . import engine, panels, properties


def register() -> None:
    """Called by Blender."""
    engine.register()
    properties.register()
    panels.register()


def unregister() -> None:
    """Called by Blender."""
    panels.unregister()
    properties.unregister()
    engine.unregister()
