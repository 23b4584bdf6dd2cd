"""The shader EtenduePhong to PhongMaterial. USD has no material for either of Phong's forms.

info:id = "EtenduePhong"
color3f inputs:reflectance = (0.5, 0.5, 0.5)   albedo seen along the normal
float inputs:exponent = 20
token inputs:form = "modified"                 or "classic", which is not symmetric
normal3f inputs:normal                         a normal map, as of UsdPreviewSurface
"""

from __future__ import annotations

from etendue import _core
from etendue.usd_reader.context import ReadContext
from etendue.usd_reader.shader_inputs import ShaderInputs

NODE_IDS = ("EtenduePhong",)

_FORMS = {"modified": _core.PhongForm.Modified, "classic": _core.PhongForm.Classic}


def read_phong(context: ReadContext, inputs: ShaderInputs) -> _core.MaterialDesc:
    """An unknown form is warned about; the symmetric one stands in."""
    model = _core.PhongMaterial()
    model.reflectance = inputs.color("reflectance", model.reflectance)
    model.exponent = inputs.number("exponent", model.exponent)
    form = str(inputs.constant("form", "modified"))
    if form not in _FORMS:
        context.report.warn(
            "Phong form", inputs.shader.GetPath(), f"unknown form '{form}'; 'modified' is used"
        )
    model.form = _FORMS.get(form, _core.PhongForm.Modified)
    return _core.MaterialDesc(model=model, normal_texture=inputs.normal_texture("normal"))
