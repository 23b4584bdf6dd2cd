"""UsdPreviewSurface to PreviewSurfaceMaterial."""

from __future__ import annotations

from etendue import _core
from etendue.usd_reader.context import ReadContext
from etendue.usd_reader.shader_inputs import ShaderInputs

NODE_IDS = ("UsdPreviewSurface", "ND_UsdPreviewSurface_surfaceshader")

# USD writes a token, MaterialX an integer.
_OPACITY_MODES = {
    "transparent": _core.PreviewOpacityMode.Transparent,
    "presence": _core.PreviewOpacityMode.Presence,
    "0": _core.PreviewOpacityMode.Transparent,
    "1": _core.PreviewOpacityMode.Presence,
}


def read_preview_surface(context: ReadContext, inputs: ShaderInputs) -> _core.MaterialDesc:
    """Displacement and occlusion mean nothing to a path traced surface: left out silently."""
    model = _core.PreviewSurfaceMaterial()
    model.diffuse_color = inputs.color("diffuseColor", model.diffuse_color)
    model.use_specular_workflow = bool(inputs.constant("useSpecularWorkflow", 0))
    model.specular_color = inputs.color("specularColor", model.specular_color)
    model.metallic = inputs.number("metallic", model.metallic)
    model.roughness = inputs.number("roughness", model.roughness)
    model.clearcoat = inputs.number("clearcoat", model.clearcoat)
    model.clearcoat_roughness = inputs.number("clearcoatRoughness", model.clearcoat_roughness)
    model.opacity = inputs.number("opacity", model.opacity)
    model.opacity_threshold = float(inputs.constant("opacityThreshold", 0.0))
    model.ior = float(inputs.constant("ior", model.ior))
    mode = str(inputs.constant("opacityMode", "transparent"))
    if mode not in _OPACITY_MODES:
        context.report.warn(
            "opacityMode",
            inputs.shader.GetPath(),
            f"unknown opacityMode '{mode}'; 'transparent' is used",
        )
    model.opacity_mode = _OPACITY_MODES.get(mode, _core.PreviewOpacityMode.Transparent)
    return _core.MaterialDesc(
        model=model,
        emission=inputs.color("emissiveColor", _core.ColorInput()),
        normal_texture=inputs.normal_texture("normal"),
    )
