"""LuxCore: a plain scene as its properties.

Its conventions: emission is radiance where gain is 1 and power and efficiency are 0, on the side of
the normal; there are triangles only; the image lies one pixel row too low; roulette changes the
mean of BIDIRCPU and is kept from happening. Paths of up to max_depth vertices from either end are
joined, so that the depth is not comparable with others': it has to be large enough not to matter.
"""

from __future__ import annotations

import os
import time
from typing import Any

import numpy as np
import pyluxcore

from parity.plain_scene import (
    Camera,
    Dielectric,
    DiskLamp,
    Floats,
    Indices,
    Lamp,
    Material,
    RectLamp,
    Scene,
    Sky,
    Surroundings,
)
from parity.stopwatch import Stopwatch
from parity.tasks import Picture, Task
from parity.tessellation import disk_corners, sphere_corners


class LuxcoreRenderer:
    """A scene, which LuxCore builds when the first picture of it starts."""

    def __init__(self, task: Task) -> None:
        assert task.scene is not None
        pyluxcore.Init(lambda _: None)
        self._task = task
        self._scene = _build(task.scene, task)

    def render(self, spp: int, seed: int) -> Picture:
        """The clock runs from before Start(), which starts the threads, until the last sample."""
        settings = _properties(_settings(self._task, spp, seed))
        session = pyluxcore.RenderSession(pyluxcore.RenderConfig(settings, self._scene))
        clock = Stopwatch()
        session.Start()
        while not session.HasDone():
            time.sleep(0.01)
            session.UpdateStats()
        wall, cpu = clock.wall, clock.cpu
        session.Stop()
        flat = np.zeros(self._task.width * self._task.height * 3, dtype=np.float32)
        session.GetFilm().GetOutputFloat(pyluxcore.FilmOutputType.RGB, flat)
        image = flat.reshape(self._task.height, self._task.width, 3)[::-1]  # row 0 is the lowest
        return Picture(image.astype(np.float64), wall, cpu)


def _settings(task: Task, spp: int, seed: int) -> dict[str, Any]:
    return {
        "renderengine.type": task.method.integrator,
        "renderengine.seed": seed + 1,
        "native.threads.count": task.threads,
        "accelerator.type": "EMBREE",
        "path.maxdepth": task.max_depth,
        "light.maxdepth": task.max_depth,
        "path.russianroulette.depth": 1 << 20,
        "path.clamping.variance.maxvalue": 0.0,
        "lightstrategy.type": "LOG_POWER",
        "sampler.type": "SOBOL",
        "sampler.sobol.adaptive.strength": 0.0,
        "film.width": task.width,
        "film.height": task.height,
        "film.filter.type": "NONE",
        "film.imagepipelines.0.0.type": "NOP",
        "film.outputs.0.type": "RGB",
        "film.outputs.0.filename": os.devnull + ".exr",
        "batch.haltspp": spp,
    }


def _properties(values: dict[str, Any]) -> Any:
    properties = pyluxcore.Properties()
    for name, value in values.items():
        properties.Set(pyluxcore.Property(name, value))
    return properties


def _tuples(values: Floats | Indices) -> list[tuple[float, ...]]:
    return [tuple(triple) for triple in values.reshape(-1, 3).tolist()]


class _Shapes:
    """Meshes under their names, and the properties that use them."""

    def __init__(self, scene: Any) -> None:
        self._scene = scene
        self.properties: dict[str, Any] = {}

    def add(self, corners: Floats, normals: Floats | None, material: dict[str, Any]) -> None:
        name = f"part{len(self.properties)}"
        indices = _tuples(np.arange(3 * len(corners)))
        own_normals = None if normals is None else _tuples(normals)
        self._scene.DefineMesh(name, _tuples(corners), indices, own_normals, None, None, None)
        for key, value in material.items():
            self.properties[f"scene.materials.{name}.{key}"] = value
        self.properties[f"scene.objects.{name}.material"] = name
        self.properties[f"scene.objects.{name}.shape"] = name


def _build(plain: Scene, task: Task) -> Any:
    scene = pyluxcore.Scene()
    scene.Parse(_properties(_camera(plain.camera, task)))
    shapes = _Shapes(scene)
    for mesh in plain.meshes:
        shapes.add(mesh.corners, mesh.normals, _material(mesh.material))
    if plain.balls:
        raise NotImplementedError("LuxCore has no spheres: the stage has to be tessellated")
    for lamp in plain.lamps:
        black = {"type": "matte", "kd": [0.0, 0.0, 0.0]}
        emission = {"emission": list(lamp.radiance), "emission.power": 0.0}
        emission |= {"emission.efficency": 0.0, "emission.theta": 90.0}
        shapes.add(_lamp_corners(lamp), None, {**black, **emission})
    for i, surroundings in enumerate(plain.surroundings):
        for key, value in _sky(surroundings).items():
            shapes.properties[f"scene.lights.sky{i}.{key}"] = value
    scene.Parse(_properties(shapes.properties))
    return scene


def _material(material: Material) -> dict[str, Any]:
    if not isinstance(material, Dielectric):
        return {"type": "matte", "kd": list(material.reflectance)}
    if material.alpha > 0:
        raise NotImplementedError("LuxCore's rough glass is not GGX")
    white = [1.0, 1.0, 1.0]
    indices = {"interiorior": material.ior, "exteriorior": 1.0}
    return {"type": "glass", "kr": white, "kt": white, **indices}


def _lamp_corners(lamp: Lamp) -> Floats:
    if isinstance(lamp, RectLamp):
        x, y = lamp.width / 2, lamp.height / 2
        rect = [(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)]
        flat = np.array([[rect[i] for i in triangle] for triangle in ((0, 2, 1), (0, 3, 2))])
    elif isinstance(lamp, DiskLamp):
        flat = disk_corners(64)[:, ::-1] * lamp.radius
    else:
        return lamp.centre + lamp.radius * sphere_corners(32, 16)
    placed: Floats = flat @ lamp.world_from_light[:3, :3].T + lamp.world_from_light[:3, 3]
    return placed


def _sky(surroundings: Surroundings) -> dict[str, Any]:
    if isinstance(surroundings, Sky):
        return {"type": "constantinfinite", "color": list(surroundings.radiance)}
    # Its latlong runs from +x over +y, about z; light space mirrored into that.
    lux = np.array([[0, 1, 0, 0], [0, 0, 1, 0], [-1, 0, 0, 0], [0, 0, 0, 1]])
    return {
        "type": "infinite",
        "file": surroundings.file,
        "gamma": 1.0,
        "gain": list(surroundings.scale),
        "transformation": (surroundings.world_from_light @ lux).T.ravel().tolist(),
        "visibilitymapcache.enable": False,
    }


def _camera(camera: Camera, task: Task) -> dict[str, Any]:
    left, right, bottom, top = camera.window
    row = (top - bottom) / task.height
    return {
        "scene.camera.type": "perspective",
        "scene.camera.lookat.orig": camera.position.tolist(),
        "scene.camera.lookat.target": (camera.position + camera.forward).tolist(),
        "scene.camera.up": camera.up.tolist(),
        "scene.camera.fieldofview": 90.0,
        "scene.camera.screenwindow": [left, right, bottom - row, top - row],
        "scene.camera.cliphither": 1e-3,
        "scene.camera.clipyon": 1e3,
        "scene.camera.lensradius": 0.0,
        "scene.camera.autofocus.enable": False,
        "scene.camera.autovolume.enable": False,
    }
