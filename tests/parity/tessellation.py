"""Round things as triangles, for renderers that have nothing else."""

from __future__ import annotations

import numpy as np

from parity.plain_scene import Floats


def sphere_corners(segments: int, rings: int) -> Floats:
    """Triangles (n, 3, 3) of a polyhedron about the origin with the area of the unit sphere.

    The mean of a convex body's projected areas is a quarter of its surface (Cauchy), so that a
    lamp of this shape lights its surroundings like the sphere, up to a faint dependence on
    direction.
    """
    theta = np.linspace(0, np.pi, rings + 1)[:, None]
    phi = np.linspace(0, 2 * np.pi, segments, endpoint=False)[None, :]
    points = np.stack(
        np.broadcast_arrays(
            np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)
        ),
        axis=-1,
    )
    upper, lower = points[:-1], points[1:]
    upper_next, lower_next = np.roll(upper, -1, axis=1), np.roll(lower, -1, axis=1)
    # The first of each pair has no area at the north pole, the second none at the south pole.
    first = np.stack([upper, lower_next, upper_next], axis=2)[1:]
    second = np.stack([upper, lower, lower_next], axis=2)[:-1]
    corners = np.concatenate([first.reshape(-1, 3, 3), second.reshape(-1, 3, 3)])
    scaled: Floats = corners * np.sqrt(4 * np.pi / area(corners))
    return scaled


def disk_corners(segments: int) -> Floats:
    """Triangles of a polygon in the plane z = 0 with the area of the unit disk, facing +z."""
    phi = 2 * np.pi * np.arange(segments) / segments
    rim = np.stack([np.cos(phi), np.sin(phi), 0 * phi], axis=-1)
    corners = np.stack([np.zeros_like(rim), rim, np.roll(rim, -1, axis=0)], axis=1)
    scaled: Floats = corners * np.sqrt(np.pi / area(corners))
    return scaled


def area(corners: Floats) -> float:
    """Of all triangles together."""
    edges = corners[:, 1:] - corners[:, :1]
    return float(np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1).sum() / 2)
