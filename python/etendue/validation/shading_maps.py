"""What leaving out the shading-normal factor does to every pixel, by theory.md §6."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from etendue.arrays import FloatArray
from etendue.luminance import quotient
from etendue.validation.shots import Shot, Studio, Values, camera_of


def predicted_ratio_map(
    studio: Studio,
    shot: Shot,
    without_normals: Values,
    lamp: tuple[float, float, float],
    subpixels: int,
) -> FloatArray:
    """(h, w): wrong over right of what a small lamp lights directly; NaN where it lights nothing.

    Looks at so many points along each side of a pixel. `without_normals` takes the stage's shading
    normals away: those seen at the same points with and without them are Ns and Ng. No scattering
    of the renderer's is used, only what its camera rays meet.
    """
    width, height = shot.resolution
    fine = (width * subpixels, height * subpixels)
    seen = replace(shot, resolution=fine)
    n_s, depth = _seen(studio, seen)
    n_g, _ = _seen(studio, replace(seen, values={**shot.values, **without_normals}))
    wo, points = _points(shot, fine, depth)
    to_lamp = np.asarray(lamp) - points
    distance = np.linalg.norm(to_lamp, axis=-1)
    wi = to_lamp / distance[..., None]
    cosines = [_dot(w, n) for w in (wi, wo) for n in (n_s, n_g)]
    light_s, light_g, eye_s, eye_g = cosines
    lit = np.all([cosine > 0 for cosine in cosines], axis=0)
    right = np.where(lit, light_s / distance**2, 0.0)
    factor = np.divide(light_g * eye_s, light_s * eye_g, out=np.zeros_like(right), where=lit)
    below, above = _pixels(right, subpixels), _pixels(right * factor, subpixels)
    return quotient(above, below)


def _seen(studio: Studio, shot: Shot) -> tuple[FloatArray, FloatArray]:
    """Normal (h, w, 3) and depth (h, w) of one sample a pixel; no length and no depth: no hit."""
    image = studio.first_hits(shot)
    normal = np.asarray(image["normal"], dtype=np.float64)
    depth = np.asarray(image["depth"], dtype=np.float64)
    return normal, np.where(np.isfinite(depth), depth, 0.0)


def _points(
    shot: Shot, resolution: tuple[int, int], depth: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """(h, w, 3) each: directions towards the camera, and what it sees, at the pixels' centres."""
    camera = camera_of(shot)
    world = np.asarray(camera.world_from_camera, dtype=np.float64)
    width, height = resolution
    x = ((np.arange(width) + 0.5) / width - 0.5) * camera.horizontal_aperture
    y = (0.5 - (np.arange(height) + 0.5) / height) * camera.vertical_aperture
    rays = np.empty((height, width, 3))
    rays[..., 0], rays[..., 1], rays[..., 2] = x[None, :], y[:, None], -camera.focal_length
    rays = rays / camera.focal_length @ world[:3, :3].T  # depth 1 along the viewing axis
    points: FloatArray = world[:3, 3] + rays * depth[..., None]
    towards: FloatArray = -rays / np.linalg.norm(rays, axis=-1, keepdims=True)
    return towards, points


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    product: FloatArray = np.einsum("...i,...i->...", a, b)
    return product


def _pixels(fine: FloatArray, subpixels: int) -> FloatArray:
    height, width = (size // subpixels for size in fine.shape)
    sums: FloatArray = fine.reshape(height, subpixels, width, subpixels).sum(axis=(1, 3))
    return sums
