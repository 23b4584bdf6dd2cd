"""UsdGeomCamera to CameraDesc."""

from __future__ import annotations

from dataclasses import dataclass

from pxr import Gf, Usd, UsdGeom

from etendue import _core
from etendue.usd_reader.context import ReadContext, SkippingUnusable, column_matrix


@dataclass(frozen=True)
class Cameras:
    """Paths of the stage's cameras; `perspective` in the order of SceneDescription.cameras."""

    perspective: tuple[str, ...]
    orthographic: tuple[str, ...]


def read_cameras(context: ReadContext, *, depth_of_field: bool) -> Cameras:
    """Fills SceneDescription.cameras, invisible ones included: they can be rendered from."""
    perspective: list[str] = []
    orthographic: list[str] = []
    for prim in context.stage.Traverse():
        if not prim.IsA(UsdGeom.Camera):
            continue
        path = str(prim.GetPath())
        if UsdGeom.Camera(prim).GetCamera(context.time).projection != Gf.Camera.Perspective:
            orthographic.append(path)
            continue
        with SkippingUnusable(context, prim):
            context.scene.add_camera(_perspective(context, prim, depth_of_field))
            perspective.append(path)
    if orthographic:
        context.report.warn(
            "orthographic camera",
            orthographic[0],
            "orthographic cameras are not supported and cannot be rendered from",
        )
    return Cameras(tuple(perspective), tuple(orthographic))


def _perspective(context: ReadContext, prim: Usd.Prim, depth_of_field: bool) -> _core.CameraDesc:
    schema = UsdGeom.Camera(prim)
    camera = schema.GetCamera(context.time)
    return _core.CameraDesc(
        name=str(prim.GetPath()),
        world_from_camera=column_matrix(camera.transform),
        horizontal_aperture=camera.horizontalAperture,
        vertical_aperture=camera.verticalAperture,
        horizontal_aperture_offset=camera.horizontalApertureOffset,
        vertical_aperture_offset=camera.verticalApertureOffset,
        focal_length=camera.focalLength,
        f_stop=camera.fStop if depth_of_field else 0.0,
        focus_distance=camera.focusDistance,
        exposure_scale=schema.ComputeLinearExposureScale(context.time),
    )
