"""The stage's RenderSettings prim."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pxr import UsdRender

from etendue import _core
from etendue.usd_reader.context import ReadContext, SkippingUnusable

_CONFORM = {
    "expandAperture": _core.ApertureConform.ExpandAperture,
    "cropAperture": _core.ApertureConform.CropAperture,
    "adjustApertureWidth": _core.ApertureConform.AdjustApertureWidth,
    "adjustApertureHeight": _core.ApertureConform.AdjustApertureHeight,
    "adjustPixelAspectRatio": _core.ApertureConform.AdjustPixelAspect,
}
_Window = tuple[float, float, float, float]


@dataclass(frozen=True)
class StageSettings:
    """What the stage asks of a render; None where it does not say."""

    path: str | None = None
    camera: str | None = None
    resolution: tuple[int, int] | None = None
    conform: _core.ApertureConform = _core.ApertureConform.ExpandAperture
    depth_of_field: bool = True
    purposes: frozenset[str] = frozenset({"default", "render"})
    material_purpose: str = "full"
    data_window: _Window = (0.0, 0.0, 1.0, 1.0)


def read_settings(context: ReadContext) -> StageSettings:
    """The prim that renderSettingsPrimPath names, with its first product's overrides."""
    stage = context.stage
    settings = UsdRender.Settings.GetStageRenderSettings(stage)
    if not settings:
        if stage.HasAuthoredMetadata("renderSettingsPrimPath"):
            path = stage.GetMetadata("renderSettingsPrimPath")
            context.report.warn(
                "renderSettingsPrimPath", path or "/", "is not a RenderSettings prim; ignored"
            )
        return StageSettings()
    with SkippingUnusable(context, settings.GetPrim()):
        return _settings(context, settings)
    return StageSettings()


def _settings(context: ReadContext, settings: UsdRender.Settings) -> StageSettings:
    prims = [settings.GetPrim(), *_products(context, settings)]

    def value(name: str) -> Any:
        """The settings' value, or the product's where it is authored there."""
        result = prims[0].GetAttribute(name).Get(context.time)
        for product in prims[1:]:
            attribute = product.GetAttribute(name)
            if attribute and attribute.HasAuthoredValue():
                result = attribute.Get(context.time)
        return result

    if value("pixelAspectRatio") != 1.0:
        context.report.warn(
            "pixelAspectRatio", settings.GetPath(), "pixels are rendered square (ratio 1)"
        )
    if settings.GetRenderingColorSpaceAttr().Get() not in (None, "", "lin_rec709_scene"):
        context.report.warn(
            "renderingColorSpace",
            settings.GetPath(),
            "the rendering space is linear Rec.709 (lin_rec709_scene)",
        )
    conform = str(value("aspectRatioConformPolicy"))
    width, height = value("resolution")
    x0, y0, x1, y1 = value("dataWindowNDC")
    if min(x0, y0) < 0 or max(x1, y1) > 1:
        context.report.warn(
            "overscan", settings.GetPath(), "dataWindowNDC beyond the image is not supported"
        )
    material_purposes = settings.GetMaterialBindingPurposesAttr().Get() or ["full"]
    return StageSettings(
        path=str(settings.GetPath()),
        camera=_camera(prims),
        resolution=(int(width), int(height)),
        conform=_CONFORM.get(conform, _core.ApertureConform.ExpandAperture),
        depth_of_field=not value("disableDepthOfField"),
        purposes=frozenset(str(p) for p in settings.GetIncludedPurposesAttr().Get()),
        material_purpose=str(material_purposes[0]),
        data_window=(float(x0), float(y0), float(x1), float(y1)),
    )


def _camera(prims: list[UsdRender.Settings]) -> str | None:
    targets = [
        target for prim in prims for target in prim.GetRelationship("camera").GetForwardedTargets()
    ]
    return str(targets[-1]) if targets else None


def _products(context: ReadContext, settings: UsdRender.Settings) -> list[UsdRender.Product]:
    """The first raster product, if any."""
    stage = context.stage
    prims = [stage.GetPrimAtPath(path) for path in settings.GetProductsRel().GetForwardedTargets()]
    raster = []
    for prim in prims:
        if not prim or not prim.IsA(UsdRender.Product):
            continue
        kind = UsdRender.Product(prim).GetProductTypeAttr().Get(context.time)
        if kind == "raster":
            raster.append(prim)
        else:
            context.report.warn(
                f"product {kind}", prim.GetPath(), f"products of type '{kind}' are not supported"
            )
    if len(raster) > 1:
        context.report.warn(
            "several products",
            raster[1].GetPath(),
            f"one product per render: {raster[0].GetPath()} is used",
        )
    return raster[:1]
