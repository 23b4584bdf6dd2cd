"""A scene made in Blender, rendered by its engine and exported by Blender as USD.

blender_scene.py METHOD SAMPLES PICTURE STAGE

METHOD is how Blender fills Hydra: HYDRA or USD.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import bpy

from plugin.host.blender_add_on import etendue_hydra

SIZE = (160, 120)


def material(name: str, **inputs: object) -> bpy.types.Material:
    """A Principled BSDF."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    for key, value in inputs.items():
        shader.inputs[key.replace("_", " ")].default_value = value
    return made


def build() -> None:
    """A glass ball and a red box on a floor under an area light."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.mesh.primitive_plane_add(size=6)
    bpy.context.object.data.materials.append(material("Floor", Base_Color=(0.6, 0.6, 0.6, 1.0)))
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0.8, 0.3, 0.5))
    bpy.context.object.data.materials.append(material("Red", Base_Color=(0.7, 0.1, 0.08, 1.0)))
    bpy.ops.mesh.primitive_uv_sphere_add(
        segments=48, ring_count=24, radius=0.6, location=(-0.7, -0.2, 0.6)
    )
    bpy.ops.object.shade_smooth()
    glass = material(
        "Glass", Base_Color=(1.0, 1.0, 1.0, 1.0), Roughness=0.0, IOR=1.5, Transmission_Weight=1.0
    )
    bpy.context.object.data.materials.append(glass)
    add_light()
    add_camera()


def add_light() -> None:
    """A square of one metre, and a black world."""
    lamp = bpy.data.lights.new("Lamp", "AREA")
    lamp.energy = 200.0
    lamp.size = 1.0
    lamp_object = bpy.data.objects.new("Lamp", lamp)
    lamp_object.location = (1.5, -1.5, 3.5)
    lamp_object.rotation_euler = (math.radians(32), 0.0, math.radians(40))
    bpy.context.scene.collection.objects.link(lamp_object)
    world = bpy.data.worlds.new("World")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (0.0, 0.0, 0.0, 1.0)
    bpy.context.scene.world = world


def add_camera() -> None:
    """Looks down at the ball and the box."""
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location = (0.0, -5.5, 2.6)
    camera.rotation_euler = (math.radians(70), 0.0, 0.0)
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def render(method: str, samples: int, picture: Path) -> None:
    """Through the add-on."""
    scene = bpy.context.scene
    scene.render.engine = "HYDRA_ETENDUE"
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    scene.hydra.export_method = method
    scene.etendue.samples = samples
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(picture)
    bpy.ops.render.render(write_still=True)


def main(method: str, samples: int, picture: Path, stage: Path) -> None:
    """See the module."""
    etendue_hydra.register()
    build()
    render(method, samples, picture)
    bpy.ops.wm.usd_export(
        filepath=str(stage), generate_materialx_network=True, convert_orientation=False
    )
    etendue_hydra.unregister()


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), Path(sys.argv[3]), Path(sys.argv[4]))
