"""UsdGeomCamera to CameraDesc."""

from __future__ import annotations

from pxr import Gf, Usd, UsdGeom

from etendue import _core
from etendue.usd_reader.context import ReadContext, SkippingUnusable, column_matrix

_PROJECTIONS = {
    Gf.Camera.Perspective: _core.CameraProjection.Perspective,
    Gf.Camera.Orthographic: _core.CameraProjection.Orthographic,
}


def read_cameras(context: ReadContext, *, depth_of_field: bool) -> tuple[str, ...]:
    """Fills SceneDescription.cameras, invisible ones included: they can be rendered from.

    Returns their paths, in that order.
    """
    paths: list[str] = []
    for prim in context.stage.Traverse():
        if not prim.IsA(UsdGeom.Camera):
            continue
        with SkippingUnusable(context, prim):
            context.scene.add_camera(_camera(context, prim, depth_of_field))
            paths.append(str(prim.GetPath()))
    return tuple(paths)


def _camera(context: ReadContext, prim: Usd.Prim, depth_of_field: bool) -> _core.CameraDesc:
    schema = UsdGeom.Camera(prim)
    camera = schema.GetCamera(context.time)
    return _core.CameraDesc(
        name=str(prim.GetPath()),
        projection=_PROJECTIONS[camera.projection],
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
