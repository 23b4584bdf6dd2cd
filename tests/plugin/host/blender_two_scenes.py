"""Renders a scene that the window does not show, and then shows it and renders it again.

blender_two_scenes.py SAMPLES BEHIND SHOWN

Writes both pictures, multi-layer .exr files. The scene that the window shows at first has other
settings, and a layer without the pass of normals.
"""

from __future__ import annotations

import sys
from pathlib import Path

import bpy

from plugin.host.blender_add_on import etendue_hydra
from plugin.host.blender_scene import build

SIZE = (64, 48)


def other_scene(samples: int) -> bpy.types.Scene:
    """All that the window's scene has, by a scene of its own."""
    shown = bpy.context.scene
    scene = bpy.data.scenes.new("Other")
    for thing in shown.collection.objects:
        scene.collection.objects.link(thing)
    scene.camera = shown.camera
    scene.world = shown.world
    scene.render.engine = "HYDRA_ETENDUE"
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    scene.render.image_settings.media_type = "MULTI_LAYER_IMAGE"
    scene.render.image_settings.color_depth = "32"
    scene.hydra.export_method = "HYDRA"
    scene.etendue.samples = samples
    scene.view_layers[0].use_pass_normal = True
    return scene


def render(scene: bpy.types.Scene, picture: Path) -> None:
    """Writes it."""
    scene.render.filepath = str(picture)
    bpy.ops.render.render(write_still=True, scene=scene.name)


def main(samples: int, behind: Path, shown: Path) -> None:
    """See the module."""
    etendue_hydra.register()
    build()
    bpy.context.scene.etendue.samples = 1
    scene = other_scene(samples)
    if bpy.context.scene == scene:
        raise RuntimeError("the window shows the other scene already")
    render(scene, behind)
    bpy.context.window.scene = scene
    render(scene, shown)
    etendue_hydra.unregister()


if __name__ == "__main__":
    main(int(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3]))
