"""Mitsuba 3: a plain scene as its dictionary.

Its conventions: an area emitter's radiance is the radiance; max_depth counts path segments, one
more than bounces; cameras look along +z with +x to the left.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import drjit
import mitsuba
import numpy as np

from parity.plain_scene import (
    Ball,
    Camera,
    Dielectric,
    DiskLamp,
    Floats,
    Lamp,
    Material,
    Mesh,
    RectLamp,
    Rgb,
    Scene,
    Sky,
    Surroundings,
)
from parity.stopwatch import Stopwatch
from parity.tasks import Picture, Task

FAST, SLOW = "llvm_ad_rgb", "scalar_rgb"
#: Compiles and runs, as a render does.
PROBE = f"""
import mitsuba
mitsuba.set_variant("{FAST}")
mitsuba.render(mitsuba.load_dict(mitsuba.cornell_box()), spp=1).numpy()
"""


class MitsubaRenderer:
    """A loaded scene and an integrator."""

    def __init__(self, task: Task) -> None:
        assert task.scene is not None
        mitsuba.set_variant(_variant())
        mitsuba.set_log_level(mitsuba.LogLevel.Error)
        drjit.set_thread_count(task.threads)
        with tempfile.TemporaryDirectory() as folder:
            self._scene = mitsuba.load_dict(_scene(task.scene, task, Path(folder)))
        self._integrator = mitsuba.load_dict(
            {"type": task.method.integrator, "max_depth": task.max_depth + 1}
        )

    def render(self, spp: int, seed: int) -> Picture:
        """The first call also compiles."""
        clock = Stopwatch()
        image = np.array(
            mitsuba.render(self._scene, integrator=self._integrator, spp=spp, seed=seed),
            dtype=np.float64,
        )
        return Picture(image, clock.wall, clock.cpu)


def _variant() -> str:
    """The fastest that works here. LLVM is tried elsewhere: it may abort its process."""
    probe = subprocess.run([sys.executable, "-c", PROBE], check=False, capture_output=True)
    if probe.returncode == 0:
        return FAST
    print(f"mitsuba: {FAST} does not work here; {SLOW} runs instead", file=sys.stderr)
    return SLOW


def _scene(scene: Scene, task: Task, folder: Path) -> dict[str, Any]:
    parts: dict[str, Any] = {"type": "scene", "sensor": _sensor(scene.camera, task)}
    for i, mesh in enumerate(scene.meshes):
        parts[f"mesh{i}"] = _mesh(mesh, folder / f"{i}.ply")
    for i, ball in enumerate(scene.balls):
        parts[f"ball{i}"] = _ball(ball)
    for i, lamp in enumerate(scene.lamps):
        parts[f"lamp{i}"] = _lamp(lamp)
    for i, surroundings in enumerate(scene.surroundings):
        parts[f"sky{i}"] = _sky(surroundings)
    return parts


def _rgb(value: Rgb) -> dict[str, Any]:
    return {"type": "rgb", "value": list(value)}


def _transform(matrix: Floats) -> Any:
    return mitsuba.ScalarTransform4f(matrix.tolist())  # its stubs know no arrays of doubles


def _bsdf(material: Material, smooth_normals: bool = False) -> dict[str, Any]:
    if isinstance(material, Dielectric):
        indices = {"int_ior": material.ior, "ext_ior": 1.0}
        if material.alpha == 0:
            return {"type": "dielectric", **indices}
        return {
            "type": "roughdielectric",
            "distribution": "ggx",
            "alpha": material.alpha,
            **indices,
        }
    diffuse = {"type": "diffuse", "reflectance": _rgb(material.reflectance)}
    # `twosided` goes by the shading normal: where that looks away from the camera but the surface
    # does not, it would light the front from behind.
    return diffuse if smooth_normals else {"type": "twosided", "bsdf": diffuse}


def _mesh(mesh: Mesh, file: Path) -> dict[str, Any]:
    _write_ply(mesh, file)
    smooth = mesh.normals is not None
    return {
        "type": "ply",
        "filename": str(file),
        "face_normals": not smooth,
        "bsdf": _bsdf(mesh.material, smooth),
    }


def _write_ply(mesh: Mesh, file: Path) -> None:
    """Binary; every triangle has vertices of its own."""
    columns = [mesh.corners.reshape(-1, 3)]
    names = ["x", "y", "z"]
    if mesh.normals is not None:
        columns.append(mesh.normals.reshape(-1, 3))
        names += ["nx", "ny", "nz"]
    faces = np.empty(len(mesh.corners), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"] = 3
    faces["corners"] = np.arange(3 * len(faces)).reshape(-1, 3)
    header = [
        "ply",
        "format binary_little_endian 1.0",
        f"element vertex {3 * len(faces)}",
        *(f"property float {name}" for name in names),
        f"element face {len(faces)}",
        "property list uchar int vertex_indices",
        "end_header\n",
    ]
    vertices = np.hstack(columns).astype("<f4")
    file.write_bytes("\n".join(header).encode() + vertices.tobytes() + faces.tobytes())


def _ball(ball: Ball) -> dict[str, Any]:
    return {
        "type": "sphere",
        "center": list(ball.centre),
        "radius": ball.radius,
        "bsdf": _bsdf(ball.material),
    }


def _lamp(lamp: Lamp) -> dict[str, Any]:
    black = {"type": "diffuse", "reflectance": _rgb((0, 0, 0))}
    common = {"emitter": {"type": "area", "radiance": _rgb(lamp.radiance)}, "bsdf": black}
    turned = np.diag([-1.0, 1.0, -1.0, 1.0])  # its flat shapes face +z
    if isinstance(lamp, RectLamp):
        size = np.diag([lamp.width / 2, lamp.height / 2, 1, 1])
        placed = _transform(lamp.world_from_light @ turned @ size)
        return {"type": "rectangle", "to_world": placed, **common}
    if isinstance(lamp, DiskLamp):
        size = np.diag([lamp.radius, lamp.radius, 1, 1])
        return {
            "type": "disk",
            "to_world": _transform(lamp.world_from_light @ turned @ size),
            **common,
        }
    return {"type": "sphere", "center": list(lamp.centre), "radius": lamp.radius, **common}


def _sky(surroundings: Surroundings) -> dict[str, Any]:
    if isinstance(surroundings, Sky):
        return {"type": "constant", "radiance": _rgb(surroundings.radiance)}
    r, g, b = surroundings.scale
    bitmap = np.array(
        mitsuba.Bitmap(surroundings.file).convert(component_format=mitsuba.Struct.Type.Float32)
    )
    return {
        "type": "envmap",  # its latlong is OpenEXR's
        "bitmap": mitsuba.Bitmap((bitmap[..., :3] * (r, g, b)).astype(np.float32)),
        "to_world": _transform(surroundings.world_from_light),
    }


def _sensor(camera: Camera, task: Task) -> dict[str, Any]:
    left, right, bottom, top = camera.window
    frame = np.eye(4)
    frame[:3, :] = np.stack([-camera.right, camera.up, camera.forward, camera.position], axis=1)
    return {
        "type": "perspective",
        "fov_axis": "x",
        "fov": float(np.degrees(2 * np.arctan((right - left) / 2))),
        # In units of the image; +x is to the left.
        "principal_point_offset_x": -(right + left) / 2 / (right - left),
        "principal_point_offset_y": (top + bottom) / 2 / (top - bottom),
        "to_world": _transform(frame),
        "near_clip": 1e-3,
        "far_clip": 1e3,
        "sampler": {"type": "independent"},
        "film": {
            "type": "hdrfilm",
            "width": task.width,
            "height": task.height,
            "pixel_format": "rgb",
            "component_format": "float32",
            "rfilter": {"type": "box"},
        },
    }
