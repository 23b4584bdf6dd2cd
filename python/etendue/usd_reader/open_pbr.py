"""OpenPBR surface to OpenPbrMaterial."""

from __future__ import annotations

from collections.abc import Sequence

from etendue import _core
from etendue.usd_reader.context import ReadContext
from etendue.usd_reader.shader_inputs import ShaderInputs

NODE_IDS = ("ND_open_pbr_surface_surfaceshader",)

# The inputs that switch on what is not rendered, with the defaults that leave it off. The other
# inputs of these layers have no effect by themselves.
_UNSUPPORTED: dict[str, float | Sequence[float]] = {
    "specular_roughness_anisotropy": 0.0,
    "transmission_scatter": (0.0, 0.0, 0.0),
    "transmission_dispersion_scale": 0.0,
    "subsurface_weight": 0.0,
    "fuzz_weight": 0.0,
    "thin_film_weight": 0.0,
}
# Of a coat, when there is one.
_UNSUPPORTED_OF_COAT: dict[str, float | Sequence[float]] = {
    "coat_color": (1.0, 1.0, 1.0),
    "coat_roughness_anisotropy": 0.0,
    "geometry_coat_normal": (0.0, 0.0, 1.0),
}


def read_open_pbr(context: ReadContext, inputs: ShaderInputs) -> _core.MaterialDesc:
    """The dielectric, metal, diffuse and coat parts; a warning for every layer left out."""
    model = _core.OpenPbrMaterial()
    model.base_weight = inputs.number("base_weight", model.base_weight)
    model.base_color = inputs.color("base_color", model.base_color)
    model.base_diffuse_roughness = inputs.number(
        "base_diffuse_roughness", model.base_diffuse_roughness
    )
    model.base_metalness = inputs.number("base_metalness", model.base_metalness)
    model.specular_weight = inputs.number("specular_weight", model.specular_weight)
    model.specular_color = inputs.color("specular_color", model.specular_color)
    model.specular_roughness = inputs.number("specular_roughness", model.specular_roughness)
    model.specular_ior = float(inputs.constant("specular_ior", model.specular_ior))
    model.transmission_weight = inputs.number("transmission_weight", model.transmission_weight)
    model.transmission_color = inputs.color("transmission_color", model.transmission_color)
    # A length, in the stage's units.
    model.transmission_depth = float(inputs.constant("transmission_depth", 0.0))
    model.coat_weight = inputs.number("coat_weight", model.coat_weight)
    model.coat_roughness = inputs.number("coat_roughness", model.coat_roughness)
    model.coat_ior = float(inputs.constant("coat_ior", model.coat_ior))
    model.coat_darkening = inputs.number("coat_darkening", model.coat_darkening)
    model.geometry_opacity = inputs.number("geometry_opacity", model.geometry_opacity)
    model.geometry_thin_walled = bool(inputs.constant("geometry_thin_walled", False))

    normal_texture = inputs.normal_texture("geometry_normal")
    _warn_of_volume(context, inputs, model)
    _warn_of_layers(context, inputs, normal_texture)
    luminance = float(inputs.constant("emission_luminance", 0.0))
    emission = _core.ColorInput()
    if luminance != 0.0:
        white = _core.ColorInput(value=(1.0, 1.0, 1.0))
        emission = inputs.color("emission_color", white, luminance)
    return _core.MaterialDesc(model=model, emission=emission, normal_texture=normal_texture)


def _warn_of_volume(
    context: ReadContext, inputs: ShaderInputs, model: _core.OpenPbrMaterial
) -> None:
    weight = model.transmission_weight
    has_volume = not model.geometry_thin_walled and (weight.texture >= 0 or weight.value > 0)
    if has_volume and model.transmission_depth > 0 and model.transmission_color.texture >= 0:
        context.report.warn(
            "open_pbr_surface textured volume",
            inputs.shader.GetPath(),
            "open_pbr_surface: a textured transmission_color tints the surface, whatever the "
            "transmission_depth",
        )


def _warn_of_layers(context: ReadContext, inputs: ShaderInputs, normal_texture: int) -> None:
    unsupported = dict(_UNSUPPORTED)
    if inputs.is_authored("coat_weight", 0.0):
        unsupported |= _UNSUPPORTED_OF_COAT
        if normal_texture >= 0:
            context.report.warn(
                "open_pbr_surface coat over a normal map",
                inputs.shader.GetPath(),
                "open_pbr_surface: the map of geometry_normal bumps the coat as well",
            )
    for name, default in unsupported.items():
        if inputs.is_authored(name, default):
            context.report.warn(
                f"open_pbr_surface {name}",
                inputs.shader.GetPath(),
                f"open_pbr_surface input '{name}' is not supported; rendered without it",
            )
