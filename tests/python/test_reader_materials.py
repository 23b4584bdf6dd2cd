"""Materials: UsdPreviewSurface, bindings, and what stands in where there is none."""

from __future__ import annotations

import numpy as np
import pytest
from pxr import Sdf, Usd, UsdGeom, UsdShade

from etendue import _core
from support.bound_materials import bound, material, open_pbr, preview
from support.stage_builder import StageBuilder, Types, warning_texts

# ------------------------------------------------------------------------------- UsdPreviewSurface


@pytest.mark.parametrize("node", ["UsdPreviewSurface", "ND_UsdPreviewSurface_surfaceshader"])
def test_preview_surface(build: StageBuilder, node: str) -> None:
    bound(
        build,
        node,
        diffuseColor=(0.1, 0.2, 0.3),
        emissiveColor=(4.0, 5.0, 6.0),
        useSpecularWorkflow=1,
        specularColor=(0.4, 0.5, 0.6),
        metallic=0.25,
        roughness=0.75,
        clearcoat=0.5,
        clearcoatRoughness=0.125,
        opacity=0.5,
        opacityThreshold=0.25,
        ior=1.25,
        displacement=3.0,
        occlusion=0.5,
    )
    contents = build.read()
    model = preview(contents)
    np.testing.assert_allclose(model.diffuse_color.value, [0.1, 0.2, 0.3])
    np.testing.assert_allclose(model.specular_color.value, [0.4, 0.5, 0.6], rtol=1e-6)
    assert model.use_specular_workflow
    assert (model.metallic.value, model.roughness.value) == (0.25, 0.75)
    assert (model.clearcoat.value, model.clearcoat_roughness.value) == (0.5, 0.125)
    assert (model.opacity.value, model.opacity_threshold, model.ior) == (0.5, 0.25, 1.25)
    assert material(contents).emission.value == [4, 5, 6]
    assert material(contents).name == "/Material"
    assert contents.warnings == ()


def test_preview_surface_defaults(build: StageBuilder) -> None:
    bound(build)
    contents = build.read()
    model, expected = preview(contents), _core.PreviewSurfaceMaterial()
    assert model.diffuse_color.value == expected.diffuse_color.value
    assert model.roughness.value == expected.roughness.value
    assert model.ior == expected.ior
    assert material(contents).emission.value == [0, 0, 0]
    assert material(contents).normal_texture == -1


@pytest.mark.parametrize(
    ("mode", "expected"),
    [
        ("transparent", _core.PreviewOpacityMode.Transparent),
        ("presence", _core.PreviewOpacityMode.Presence),
        (0, _core.PreviewOpacityMode.Transparent),
        (1, _core.PreviewOpacityMode.Presence),
    ],
)
def test_opacity_mode(
    build: StageBuilder, mode: str | int, expected: _core.PreviewOpacityMode
) -> None:
    bound(build, opacityMode=mode)
    assert preview(build.read()).opacity_mode == expected


def test_materials_are_read_once(build: StageBuilder) -> None:
    shared = build.material()
    build.bind(build.quad("/A"), shared)
    build.bind(build.quad("/B"), shared)
    assert len(build.read().scene.materials) == 1


def test_binding_strength(build: StageBuilder) -> None:
    parent = UsdGeom.Xform.Define(build.stage, "/Parent")
    strong, weak = build.material(path="/Strong"), build.material(path="/Weak")
    UsdShade.MaterialBindingAPI.Apply(parent.GetPrim()).Bind(
        strong, UsdShade.Tokens.strongerThanDescendants
    )
    build.bind(build.quad("/Parent/Quad"), weak)
    assert material(build.read()).name == "/Strong"


def test_collection_binding(build: StageBuilder) -> None:
    build.quad("/World/Quad")
    world = build.stage.GetPrimAtPath("/World")
    collection = Usd.CollectionAPI.Apply(world, "all")
    collection.CreateIncludesRel().SetTargets([Sdf.Path("/World/Quad")])
    UsdShade.MaterialBindingAPI.Apply(world).Bind(collection, build.material(), "all")
    assert material(build.read()).name == "/Material"


def test_values_through_interfaces(build: StageBuilder) -> None:
    surface = bound(build)
    shared = UsdShade.Material(build.stage.GetPrimAtPath("/Material"))
    interface = shared.CreateInput("tint", Types.Color3f)
    interface.Set((0.25, 0.5, 0.75))
    graph = UsdShade.NodeGraph.Define(build.stage, "/Material/Graph")
    inner = graph.CreateInput("tint", Types.Color3f)
    inner.ConnectToSource(interface)
    surface.CreateInput("diffuseColor", Types.Color3f).ConnectToSource(inner)
    assert preview(build.read()).diffuse_color.value == [0.25, 0.5, 0.75]


def test_broken_connection(build: StageBuilder) -> None:
    surface = bound(build)
    tint = surface.CreateInput("diffuseColor", Types.Color3f)
    tint.Set((0.25, 0.5, 0.75))
    tint.GetAttr().AddConnection("/Nowhere.outputs:rgb")
    contents = build.read()
    assert preview(contents).diffuse_color.value == [0.25, 0.5, 0.75]
    assert "the connection leads nowhere" in warning_texts(contents)


def test_color_space_of_an_input(build: StageBuilder) -> None:
    surface = bound(build, diffuseColor=(0.5, 0.5, 0.5))
    surface.GetInput("diffuseColor").GetAttr().SetColorSpace("srgb_texture")
    np.testing.assert_allclose(preview(build.read()).diffuse_color.value, [0.21404] * 3, atol=1e-4)


# -------------------------------------------------------------------------------------- fallbacks


def test_unknown_node(build: StageBuilder) -> None:
    build.bind(build.quad(), build.material("ND_standard_surface_surfaceshader"))
    contents = build.read()
    assert isinstance(material(contents).model, _core.DiffuseMaterial)
    assert warning_texts(contents) == (
        "/Material: surface node 'ND_standard_surface_surfaceshader' is not supported; "
        "displayColor is rendered instead"
    )


def test_material_without_surface(build: StageBuilder) -> None:
    build.bind(build.quad(), UsdShade.Material.Define(build.stage, "/Material"))
    assert "/Material: the material has no surface shader" in warning_texts(build.read())


def test_missing_material(build: StageBuilder) -> None:
    prim = build.quad().GetPrim()
    UsdShade.MaterialBindingAPI.Apply(prim).GetDirectBindingRel().SetTargets(["/Nowhere"])
    assert "/Quad: the bound material </Nowhere> does not exist" in warning_texts(build.read())


def test_no_material_at_all(build: StageBuilder) -> None:
    build.quad()
    contents = build.read()
    model = material(contents).model
    assert isinstance(model, _core.DiffuseMaterial)
    assert model.reflectance.value == _core.DiffuseMaterial().reflectance.value
    assert contents.warnings == ()


def test_display_color(build: StageBuilder) -> None:
    build.quad().CreateDisplayColorAttr([(0.25, 0.5, 0.75)])
    contents = build.read()
    model = material(contents).model
    assert isinstance(model, _core.DiffuseMaterial)
    assert model.reflectance.value == [0.25, 0.5, 0.75]


def test_varying_display_color(build: StageBuilder) -> None:
    primvar = build.quad().CreateDisplayColorPrimvar("vertex")
    primvar.Set([(0, 0, 0), (1, 0, 0), (1, 0, 0), (0, 0, 0)])
    contents = build.read()
    model = material(contents).model
    assert isinstance(model, _core.DiffuseMaterial)
    assert model.reflectance.value == [0.5, 0, 0]
    assert "/Quad: displayColor varies" in warning_texts(contents)


def test_display_opacity(build: StageBuilder) -> None:
    quad = build.quad()
    quad.CreateDisplayColorAttr([(0.25, 0.5, 0.75)])
    quad.CreateDisplayOpacityAttr([0.5])
    model = open_pbr(build.read())
    assert model.base_color.value == [0.25, 0.5, 0.75]
    assert model.geometry_opacity.value == 0.5
    assert model.specular_weight.value == 0
