"""UsdLux lights to LightDesc, attribute by attribute; core knows what they mean."""

from __future__ import annotations

from typing import Any

from pxr import Sdf, Usd, UsdGeom, UsdLux, UsdShade

from etendue import _core
from etendue.usd_reader.colors import to_rendering_space
from etendue.usd_reader.context import ReadContext
from etendue.usd_reader.texture_files import file_color_space, texture_file

_KINDS = {
    "RectLight": _core.LightKind.Rect,
    "DiskLight": _core.LightKind.Disk,
    "SphereLight": _core.LightKind.Sphere,
    "CylinderLight": _core.LightKind.Cylinder,
    "DistantLight": _core.LightKind.Distant,
    "DomeLight": _core.LightKind.Dome,
    "DomeLight_1": _core.LightKind.Dome,
}

# How a dome's texture covers the sphere; automatic is latlong unless the file says otherwise.
_LATLONG = ("automatic", "latlong")

INDEPENDENT = "independent"
TINTED = "materialGlowTintsLight"
NO_RESPONSE = "noMaterialResponse"


def is_light(prim: Usd.Prim) -> bool:
    """Lights are known by their API, not by their type."""
    return bool(prim.HasAPI(UsdLux.LightAPI))


def is_mesh_light(prim: Usd.Prim) -> bool:
    """A mesh that emits light of its own."""
    return is_light(prim) and bool(prim.IsA(UsdGeom.Mesh))


def material_sync_mode(context: ReadContext, prim: Usd.Prim) -> str:
    """How a mesh light and its material go together."""
    return str(UsdLux.LightAPI(prim).GetMaterialSyncModeAttr().Get(context.time))


def read_light(context: ReadContext, prim: Usd.Prim) -> _core.LightDesc | None:
    """The light without its transform, or None (after a warning) when its kind is not supported."""
    if is_mesh_light(prim):
        desc = _core.LightDesc(kind=_core.LightKind.Mesh)
        desc.tinted_by_material = material_sync_mode(context, prim) == TINTED
    else:
        type_name = str(prim.GetTypeName())
        if type_name not in _KINDS:
            context.report.warn(
                f"light {type_name}", prim.GetPath(), f"{type_name} is not supported; skipped"
            )
            return None
        desc = _core.LightDesc(kind=_KINDS[type_name])
        _set_size(context, prim, desc)
    desc.name = str(prim.GetPath())
    _set_emission(context, prim, desc)
    if prim.HasAPI(UsdLux.ShapingAPI):
        _set_shaping(context, prim, desc)
    _warn_unsupported(context, prim)
    return desc


def _value(context: ReadContext, prim: Usd.Prim, name: str) -> Any:
    return prim.GetAttribute(name).Get(context.time)


def _set_size(context: ReadContext, prim: Usd.Prim, desc: _core.LightDesc) -> None:
    if desc.kind == _core.LightKind.Rect:
        desc.width = _value(context, prim, "inputs:width")
        desc.height = _value(context, prim, "inputs:height")
        _set_texture(context, prim, desc)
    elif desc.kind == _core.LightKind.Disk:
        desc.radius = _value(context, prim, "inputs:radius")
    elif desc.kind == _core.LightKind.Sphere:
        desc.radius = _value(context, prim, "inputs:radius")
        desc.treat_as_point = bool(_value(context, prim, "treatAsPoint"))
    elif desc.kind == _core.LightKind.Cylinder:
        desc.length = _value(context, prim, "inputs:length")
        desc.radius = _value(context, prim, "inputs:radius")
        desc.treat_as_line = bool(_value(context, prim, "treatAsLine"))
    elif desc.kind == _core.LightKind.Distant:
        desc.angle = _value(context, prim, "inputs:angle")
    elif desc.kind == _core.LightKind.Dome:
        desc.pole_axis = _pole_axis(context, prim)
        _set_dome_texture(context, prim, desc)


def _pole_axis(context: ReadContext, prim: Usd.Prim) -> _core.Axis:
    """DomeLight's is Y whatever the stage's up axis; DomeLight_1 says, and may leave it to that."""
    if prim.GetTypeName() == "DomeLight":
        return _core.Axis.Y
    pole = str(_value(context, prim, "poleAxis"))
    if pole == "scene":
        pole = str(UsdGeom.GetStageUpAxis(context.stage))
    return _core.Axis.Z if pole == "Z" else _core.Axis.Y


def _set_dome_texture(context: ReadContext, prim: Usd.Prim, desc: _core.LightDesc) -> None:
    layout = str(_value(context, prim, "inputs:texture:format"))
    authored = _value(context, prim, "inputs:texture:file")
    if isinstance(authored, Sdf.AssetPath) and authored.path and layout not in _LATLONG:
        context.report.warn(
            f"dome texture format {layout}",
            prim.GetPath(),
            f"texture:format '{layout}' is not supported, only latlong; "
            "the constant colour is used",
        )
        return
    _set_texture(context, prim, desc)


def _set_texture(context: ReadContext, prim: Usd.Prim, desc: _core.LightDesc) -> None:
    attribute = prim.GetAttribute("inputs:texture:file")
    asset = attribute.Get(context.time)
    if not isinstance(asset, Sdf.AssetPath) or not asset.path:
        return
    if UsdShade.UdimUtils.IsUdimIdentifier(asset.path):
        context.report.warn(
            "light texture of tiles",
            prim.GetPath(),
            f"texture file '{asset.path}' is a UDIM set, which a light has no places for; "
            "the constant colour is used",
        )
        return
    file = texture_file(context, prim.GetPath(), attribute, asset, "the constant colour")
    if file is not None:
        desc.texture_file = file
        desc.texture_color_space = file_color_space(context, prim.GetPath(), attribute)


def _set_emission(context: ReadContext, prim: Usd.Prim, desc: _core.LightDesc) -> None:
    light = UsdLux.LightAPI(prim)
    color = light.GetColorAttr()
    desc.intensity = light.GetIntensityAttr().Get(context.time)
    desc.exposure = light.GetExposureAttr().Get(context.time)
    desc.color = to_rendering_space(context, color, color.Get(context.time))
    desc.normalize = bool(light.GetNormalizeAttr().Get(context.time))
    if light.GetEnableColorTemperatureAttr().Get(context.time):
        kelvin = light.GetColorTemperatureAttr().Get(context.time)
        desc.color_temperature_rgb = tuple(UsdLux.BlackbodyTemperatureAsRgb(kelvin))


def _set_shaping(context: ReadContext, prim: Usd.Prim, desc: _core.LightDesc) -> None:
    shaping = UsdLux.ShapingAPI(prim)
    if shaping.GetShapingIesFileAttr().HasAuthoredValue():
        context.report.warn(
            "light ies", prim.GetPath(), "IES profiles are not supported; the light does without"
        )
    if desc.kind in (_core.LightKind.Dome, _core.LightKind.Distant):
        if _departs(context, prim, "inputs:shaping:"):
            context.report.warn(
                "light shaping",
                prim.GetPath(),
                f"a {prim.GetTypeName()} has no shape; its ShapingAPI is ignored",
            )
        return
    tint = shaping.GetShapingFocusTintAttr()
    desc.shaping = _core.ShapingDesc(
        focus=shaping.GetShapingFocusAttr().Get(context.time),
        focus_tint=to_rendering_space(context, tint, tint.Get(context.time)),
        cone_angle=shaping.GetShapingConeAngleAttr().Get(context.time),
        cone_softness=shaping.GetShapingConeSoftnessAttr().Get(context.time),
    )


# ----------------------------------------------------------------------------------- unsupported


def _warn_unsupported(context: ReadContext, prim: Usd.Prim) -> None:
    def warn(kind: str, message: str) -> None:
        context.report.warn(f"light {kind}", prim.GetPath(), message)

    light = UsdLux.LightAPI(prim)
    for name, attribute in (
        ("diffuse", light.GetDiffuseAttr()),
        ("specular", light.GetSpecularAttr()),
    ):
        if attribute.Get(context.time) != 1.0:
            warn(name, f"inputs:{name} is not physical and not supported; 1 is used")
    if light.GetFiltersRel().GetTargets():
        warn("filters", "light filters are not supported; the unfiltered light is used")
    if prim.GetRelationship("portals").GetTargets():
        warn("portals", "dome portals are not supported; the whole dome is used")
    if prim.HasAPI(UsdLux.ShadowAPI) and _departs(context, prim, "inputs:shadow:"):
        warn("shadow", "ShadowAPI is not physical and not supported; shadows are as they are")
    for collection in (light.GetLightLinkCollectionAPI(), light.GetShadowLinkCollectionAPI()):
        if _is_linked(collection):
            warn(
                f"linking {collection.GetName()}",
                f"{collection.GetName()} is not supported; the light reaches everything",
            )


def _departs(context: ReadContext, prim: Usd.Prim, prefix: str) -> bool:
    """Whether an attribute under `prefix` is set to something else than its schema's fallback."""
    definition = prim.GetPrimDefinition()
    for name in prim.GetPropertyNames():
        if not name.startswith(prefix):
            continue
        attribute = prim.GetAttribute(name)
        if attribute.HasAuthoredValue() and attribute.Get(
            context.time
        ) != definition.GetAttributeFallbackValue(name):
            return True
    return False


def _is_linked(collection: Usd.CollectionAPI) -> bool:
    """Whether the light reaches less than everything."""
    return bool(
        collection.GetIncludesRel().GetTargets()
        or collection.GetExcludesRel().GetTargets()
        or not collection.GetIncludeRootAttr().Get()
    )
