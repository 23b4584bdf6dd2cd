"""Bound materials to MaterialDesc: binding resolution, choice of the surface shader, fallbacks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from pxr import Usd, UsdShade

from etendue import _core
from etendue.usd_reader import open_pbr, phong, preview_surface
from etendue.usd_reader.colors import to_rendering_space
from etendue.usd_reader.context import ReadContext, SkippingUnusable
from etendue.usd_reader.networks import shader_id
from etendue.usd_reader.primvars import read_primvar
from etendue.usd_reader.shader_inputs import ShaderInputs
from etendue.usd_reader.textures import TextureReader

_Reader = Callable[[ReadContext, ShaderInputs], _core.MaterialDesc]

_READERS: dict[str, _Reader] = {
    **dict.fromkeys(preview_surface.NODE_IDS, preview_surface.read_preview_surface),
    **dict.fromkeys(open_pbr.NODE_IDS, open_pbr.read_open_pbr),
    **dict.fromkeys(phong.NODE_IDS, phong.read_phong),
}
# In order of preference; the empty one is the universal context.
_RENDER_CONTEXTS = ("mtlx", "")


@dataclass(frozen=True)
class BoundMaterial:
    """An index into SceneDescription.materials and what geometry needs to know of it."""

    index: int
    st: str | None = None  # the texture coordinates that its textures are read at
    emits: bool = False


class MaterialReader:
    """Fills SceneDescription.materials, once per material."""

    def __init__(self, context: ReadContext) -> None:
        self._context = context
        self._textures = TextureReader(context)
        self._materials: dict[str, BoundMaterial | None] = {}
        self._fallbacks: dict[tuple[tuple[float, float, float] | None, float], BoundMaterial] = {}
        self._black: BoundMaterial | None = None

    def bound(self, prim: Usd.Prim, gprim: Usd.Prim | None = None) -> BoundMaterial:
        """What `prim` is made of. Without a usable material: displayColor.

        For a GeomSubset, `gprim` is the mesh that carries displayColor.
        """
        binding = UsdShade.MaterialBindingAPI(prim)
        material, _ = binding.ComputeBoundMaterial(self._context.material_purpose)
        if material:
            bound = self._read_once(material)
            if bound is not None:
                return bound
        else:
            self._warn_dangling(prim)
        return self._fallback(gprim or prim)

    def black(self) -> BoundMaterial:
        """A surface that reflects nothing: mesh lights without material response."""
        if self._black is None:
            index = self._context.scene.add_material(
                _core.MaterialDesc(
                    name="no material response",
                    model=_core.DiffuseMaterial(reflectance=_core.ColorInput()),
                )
            )
            self._black = BoundMaterial(index)
        return self._black

    def _read_once(self, material: UsdShade.Material) -> BoundMaterial | None:
        path = str(material.GetPath())
        if path not in self._materials:
            self._materials[path] = None
            with SkippingUnusable(self._context, material.GetPrim()):
                self._materials[path] = self._read(material)
        return self._materials[path]

    def _read(self, material: UsdShade.Material) -> BoundMaterial | None:
        unknown: list[str] = []
        for render_context in _RENDER_CONTEXTS:
            shader, _, _ = material.ComputeSurfaceSource(render_context)
            if not shader:
                continue
            node = shader_id(shader)
            if node in _READERS:
                return self._fill(material, shader, _READERS[node])
            unknown.append(node or "without an id")
        if unknown:
            what = f"surface node '{unknown[0]}' is not supported"
        else:
            what = "the material has no surface shader"
        self._context.report.warn(
            f"material {material.GetPath()}",
            material.GetPath(),
            f"{what}; displayColor is rendered instead",
        )
        return None

    def _fill(
        self, material: UsdShade.Material, shader: UsdShade.Shader, reader: _Reader
    ) -> BoundMaterial:
        inputs = ShaderInputs(self._context, self._textures, shader)
        desc = reader(self._context, inputs)
        desc.name = str(material.GetPath())
        if len(inputs.st_names) > 1:
            self._context.report.warn(
                f"several texture coordinates {material.GetPath()}",
                material.GetPath(),
                f"one set of texture coordinates per material: '{inputs.st_names[0]}' is used "
                f"for {', '.join(repr(name) for name in inputs.st_names[1:])} too",
            )
        emits = desc.emission.texture >= 0 or any(value > 0 for value in desc.emission.value)
        index = self._context.scene.add_material(desc)
        return BoundMaterial(index, inputs.st_names[0] if inputs.st_names else None, emits)

    def _warn_dangling(self, prim: Usd.Prim) -> None:
        targets = UsdShade.MaterialBindingAPI(prim).GetDirectBindingRel().GetTargets()
        if targets:
            self._context.report.warn(
                f"missing material {targets[0]}",
                prim.GetPath(),
                f"the bound material <{targets[0]}> does not exist; displayColor is rendered "
                "instead",
            )

    # --------------------------------------------------------------------------- displayColor

    def _fallback(self, prim: Usd.Prim) -> BoundMaterial:
        color = self._display_color(prim)
        opacity = self._display_opacity(prim)
        key = (color, opacity)
        if key not in self._fallbacks:
            self._fallbacks[key] = BoundMaterial(
                self._context.scene.add_material(_display_material(color, opacity))
            )
        return self._fallbacks[key]

    def _display_color(self, prim: Usd.Prim) -> tuple[float, float, float] | None:
        primvar = read_primvar(self._context, prim, "displayColor")
        if primvar is None or not len(primvar.values) or primvar.values.shape[1] != 3:
            return None
        if len(primvar.values) > 1 and np.ptp(primvar.values, axis=0).any():
            self._context.report.warn(
                "varying displayColor",
                prim.GetPath(),
                "displayColor varies over the surface; its mean is rendered",
            )
        mean = [float(channel) for channel in primvar.values.mean(axis=0)]
        return to_rendering_space(self._context, primvar.attribute, mean)

    def _display_opacity(self, prim: Usd.Prim) -> float:
        primvar = read_primvar(self._context, prim, "displayOpacity")
        if primvar is None or not len(primvar.values) or primvar.values.shape[1] != 1:
            return 1.0
        if len(primvar.values) > 1 and np.ptp(primvar.values):
            self._context.report.warn(
                "varying displayOpacity",
                prim.GetPath(),
                "displayOpacity varies over the surface; its mean is rendered",
            )
        return float(np.clip(primvar.values.mean(), 0.0, 1.0))


def _display_material(
    color: tuple[float, float, float] | None, opacity: float
) -> _core.MaterialDesc:
    """Diffuse, with the core's default reflectance where no colour is authored."""
    reflectance = _core.DiffuseMaterial().reflectance
    if color is not None:
        reflectance = _core.ColorInput(value=color)
    if opacity >= 1.0:
        return _core.MaterialDesc(
            name="displayColor", model=_core.DiffuseMaterial(reflectance=reflectance)
        )
    model = _core.OpenPbrMaterial(
        base_color=reflectance,
        specular_weight=_core.FloatInput(value=0.0),
        geometry_opacity=_core.FloatInput(value=opacity),
    )
    return _core.MaterialDesc(name="displayColor", model=model)
