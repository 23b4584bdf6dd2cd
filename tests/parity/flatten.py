"""A scene description, as the USD reader makes it, told as a plain scene.

The reader is everyone's. What its values mean is taken from the schemas and not from the core,
which this is there to check. What the parity stages do not use is refused.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from etendue import _core
from parity.plain_scene import (
    Ball,
    Camera,
    Dielectric,
    Diffuse,
    DiskLamp,
    Floats,
    Indices,
    Lamp,
    LatlongSky,
    Material,
    Mesh,
    RectLamp,
    Rgb,
    Scene,
    Sky,
    SphereLamp,
    Surroundings,
)


class UnsupportedError(Exception):
    """The stage holds something that the parity check has no words for."""


def flatten(scene: _core.SceneDescription, camera: int, aspect: float) -> Scene:
    """The scene as seen by one of its cameras in an image of this aspect (width / height)."""
    if scene.instances:
        raise UnsupportedError(f"{scene.source}: instances")
    meshes: list[Mesh] = []
    balls: list[Ball] = []
    for shape in scene.shapes:
        geometry = scene.geometries[shape.geometry]
        materials = [_material(scene.materials[index]) for index in shape.materials]
        if isinstance(geometry, _core.SphereDesc):
            balls.append(_ball(shape, geometry, materials[0]))
        else:
            meshes.extend(_meshes(shape, geometry, materials))
    lights = [_light(light) for light in scene.lights]
    return Scene(
        meshes=tuple(meshes),
        balls=tuple(balls),
        lamps=tuple(light for light in lights if not isinstance(light, Sky | LatlongSky)),
        surroundings=tuple(light for light in lights if isinstance(light, Sky | LatlongSky)),
        camera=_camera(scene.cameras[camera], aspect),
    )


# --- materials ------------------------------------------------------------------------------------


def _material(desc: _core.MaterialDesc) -> Material:
    model = desc.model
    if desc.normal_texture >= 0 or any(desc.emission.value):
        raise UnsupportedError(f"{desc.name}: normal maps and emission")
    if not isinstance(model, _core.OpenPbrMaterial):
        raise UnsupportedError(f"{desc.name}: {type(model).__name__}")
    textured = [model.base_color.texture, model.specular_roughness.texture]
    if any(texture >= 0 for texture in textured) or model.base_metalness.value:
        raise UnsupportedError(f"{desc.name}: textures and metal")
    if model.transmission_weight.value == 1 and model.transmission_depth == 0:
        # OpenPBR: alpha is the square of the perceptual roughness.
        return Dielectric(model.specular_ior, model.specular_roughness.value**2)
    if model.transmission_weight.value == 0 and model.specular_weight.value == 0:
        weight = model.base_weight.value
        return Diffuse(_rgb(weight * value for value in model.base_color.value))
    raise UnsupportedError(f"{desc.name}: a mixture")


def _rgb(values: Iterator[float] | Sequence[float]) -> Rgb:
    r, g, b = values
    return (r, g, b)


# --- shapes ---------------------------------------------------------------------------------------


def _ball(shape: _core.ShapeDesc, sphere: _core.SphereDesc, material: Material) -> Ball:
    matrix = shape.parent_from_object
    return Ball(shape.name, matrix[:3, 3], sphere.radius * _scale(matrix, shape.name), material)


def _scale(matrix: Floats, name: str) -> float:
    """The factor of a similarity."""
    axes = matrix[:3, :3]
    scale = float(np.cbrt(abs(np.linalg.det(axes))))
    if not np.allclose(axes @ axes.T, scale**2 * np.eye(3), rtol=0, atol=1e-6 * scale**2):
        raise UnsupportedError(f"{name}: a sphere that is not round")
    return scale


def _meshes(
    shape: _core.ShapeDesc, geometry: _core.GeometryDesc, materials: Sequence[Material]
) -> Iterator[Mesh]:
    """One for each material."""
    if isinstance(geometry, _core.CubeDesc):
        geometry = _cube(geometry.size)
    if not isinstance(geometry, _core.MeshDesc):
        raise UnsupportedError(f"{shape.name}: {type(geometry).__name__}")
    faces, indices = _triangles(geometry)
    matrix = shape.parent_from_object
    corners = _place(matrix, geometry.points.astype(float))[indices]
    normals = _normals(geometry, shape, indices)
    if geometry.left_handed != (np.linalg.det(matrix[:3, :3]) < 0):
        corners = corners[:, ::-1]
        normals = None if normals is None else normals[:, ::-1]
    slots = geometry.face_materials[faces] if len(geometry.face_materials) else 0 * faces
    for slot, material in enumerate(materials):
        own = slots == slot
        if own.any():
            name = f"{shape.name}:{slot}"
            yield Mesh(name, corners[own], None if normals is None else normals[own], material)


def _triangles(mesh: _core.MeshDesc) -> tuple[Indices, Indices]:
    """Fans about each face's first corner: per triangle its face, and its three point indices."""
    faces, triangles, first = [], [], 0
    for face, count in enumerate(mesh.face_vertex_counts):
        corners = mesh.face_vertex_indices[first : first + count]
        for i in range(1, count - 1):
            faces.append(face)
            triangles.append((corners[0], corners[i], corners[i + 1]))
        first += count
    return np.array(faces), np.array(triangles)


def _normals(mesh: _core.MeshDesc, shape: _core.ShapeDesc, indices: Indices) -> Floats | None:
    if not len(mesh.normals):
        return None
    if mesh.normals_interpolation != _core.Interpolation.Vertex:
        raise UnsupportedError(f"{shape.name}: normals that are not per vertex")
    turned = mesh.normals.astype(float) @ np.linalg.inv(shape.parent_from_object[:3, :3])
    unit: Floats = turned / np.linalg.norm(turned, axis=1, keepdims=True)
    by_corner: Floats = unit[indices]
    return by_corner


def _place(matrix: Floats, points: Floats) -> Floats:
    placed: Floats = points @ matrix[:3, :3].T + matrix[:3, 3]
    return placed


def _cube(size: float) -> _core.MeshDesc:
    corners = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    faces = [
        [0, 1, 3, 2],
        [4, 6, 7, 5],
        [0, 4, 5, 1],
        [2, 3, 7, 6],
        [0, 2, 6, 4],
        [1, 5, 7, 3],
    ]
    return _core.MeshDesc(
        points=np.array(corners) * (size / 2),
        face_vertex_counts=np.full(6, 4),
        face_vertex_indices=np.array(faces).ravel(),
    )


# --- lights ---------------------------------------------------------------------------------------


def _light(desc: _core.LightDesc) -> Lamp | Surroundings:
    matrix = desc.world_from_light
    if desc.kind == _core.LightKind.Rect:
        x, y = (float(np.linalg.norm(matrix[:3, axis])) for axis in (0, 1))
        radiance = _radiance(desc, desc.width * x * desc.height * y)
        return RectLamp(desc.name, matrix, desc.width, desc.height, radiance)
    if desc.kind == _core.LightKind.Disk:
        radius = desc.radius * _scale(matrix, desc.name)
        radiance = _radiance(desc, np.pi * radius**2)
        return DiskLamp(desc.name, matrix, desc.radius, radiance)
    if desc.kind == _core.LightKind.Sphere and not desc.treat_as_point:
        radius = desc.radius * _scale(matrix, desc.name)
        radiance = _radiance(desc, 4 * np.pi * radius**2)
        return SphereLamp(desc.name, matrix[:3, 3], radius, radiance)
    if desc.kind == _core.LightKind.Dome:
        return _sky(desc)
    raise UnsupportedError(f"{desc.name}: {desc.kind.name} light")


def _sky(desc: _core.LightDesc) -> Surroundings:
    if not desc.texture_file:
        return Sky(_radiance(desc, 1))
    if desc.pole_axis != _core.Axis.Y:
        raise UnsupportedError(f"{desc.name}: a pole that is not y")
    return LatlongSky(desc.world_from_light, desc.texture_file, _radiance(desc, 1))


def _radiance(desc: _core.LightDesc, size: float) -> Rgb:
    """UsdLux: intensity 2^exposure over the world-space area if normalised, times the colours."""
    strength = desc.intensity * 2**desc.exposure / (size if desc.normalize else 1)
    tints = zip(desc.color, desc.color_temperature_rgb, strict=True)
    return _rgb(strength * color * temperature for color, temperature in tints)


# --- camera ---------------------------------------------------------------------------------------


def _camera(desc: _core.CameraDesc, aspect: float) -> Camera:
    if desc.projection != _core.CameraProjection.Perspective:
        raise UnsupportedError(f"{desc.name}: {desc.projection.name} projection")
    if desc.f_stop > 0 or desc.exposure_scale != 1:
        raise UnsupportedError(f"{desc.name}: lens or exposure")
    width, height = desc.horizontal_aperture, desc.vertical_aperture
    if not np.isclose(width / height, aspect):
        raise UnsupportedError(f"{desc.name}: aspect {width / height:g} of an image of {aspect:g}")
    matrix = desc.world_from_camera
    forward = -matrix[:3, 2] / np.linalg.norm(matrix[:3, 2])
    right = np.cross(forward, matrix[:3, 1])
    right /= np.linalg.norm(right)
    x, y = desc.horizontal_aperture_offset, desc.vertical_aperture_offset
    edges = (x - width / 2, x + width / 2, y - height / 2, y + height / 2)
    left, right_edge, bottom, top = (edge / desc.focal_length for edge in edges)
    return Camera(
        position=matrix[:3, 3],
        right=right,
        up=np.cross(right, forward),
        forward=forward,
        window=(left, right_edge, bottom, top),
    )
