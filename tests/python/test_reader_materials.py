"""Materials, textures and their coordinates."""

from __future__ import annotations

import math
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pxr import Sdf, Usd, UsdGeom, UsdShade, UsdUtils

from etendue import _core
from etendue.usd_reader import StageContents
from support.stage_builder import StageBuilder, Types, warning_texts

OPEN_PBR = "ND_open_pbr_surface_surfaceshader"


def material(contents: StageContents) -> _core.MaterialDesc:
    """What the only shape is made of."""
    (shape,) = contents.scene.shapes
    return contents.scene.materials[shape.materials[0]]


def preview(contents: StageContents) -> _core.PreviewSurfaceMaterial:
    model = material(contents).model
    assert isinstance(model, _core.PreviewSurfaceMaterial)
    return model


def open_pbr(contents: StageContents) -> _core.OpenPbrMaterial:
    model = material(contents).model
    assert isinstance(model, _core.OpenPbrMaterial)
    return model


def bound(build: StageBuilder, node: str = "UsdPreviewSurface", **inputs: Any) -> UsdShade.Shader:
    """A quad with a material; returns the surface node."""
    build.bind(build.quad(), build.material(node, **inputs))
    return UsdShade.Shader(build.stage.GetPrimAtPath("/Material/Surface"))


@pytest.fixture
def picture(tmp_path: Path) -> Path:
    """A file that stands for a texture; the reader does not look inside."""
    file = tmp_path / "picture.png"
    file.write_bytes(b"not looked at")
    return file


def textured(
    build: StageBuilder,
    file: Path | str,
    output: str = "rgb",
    name: str = "diffuseColor",
    **inputs: Any,
) -> UsdShade.Shader:
    """bound(), with a texture node on one input."""
    surface = bound(build)
    node = build.node("UsdUVTexture", "/Material/Texture", file=Sdf.AssetPath(str(file)), **inputs)
    surface.CreateInput(name, Types.Color3f).ConnectToSource(
        node.CreateOutput(output, Types.Float3)
    )
    return node


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


# ---------------------------------------------------------------------------------------- OpenPBR


def test_open_pbr(build: StageBuilder) -> None:
    build.bind(
        build.quad(),
        build.material(
            OPEN_PBR,
            context="mtlx",
            base_weight=0.5,
            base_color=(0.25, 0.5, 0.75),
            base_diffuse_roughness=0.625,
            base_metalness=0.125,
            specular_weight=0.75,
            specular_color=(0.5, 0.25, 0.125),
            specular_roughness=0.0,
            specular_ior=1.25,
            transmission_weight=1.0,
            transmission_color=(0.75, 0.5, 0.25),
            coat_weight=0.25,
            coat_roughness=0.5,
            coat_ior=1.75,
            coat_darkening=0.125,
            geometry_opacity=0.875,
            geometry_thin_walled=True,
            emission_luminance=2.0,
            emission_color=(0.5, 1.0, 0.25),
        ),
    )
    contents = build.read()
    model = open_pbr(contents)
    assert model.base_weight.value == 0.5
    assert model.base_color.value == [0.25, 0.5, 0.75]
    assert model.base_diffuse_roughness.value == 0.625
    assert model.base_metalness.value == 0.125
    assert model.specular_weight.value == 0.75
    assert model.specular_color.value == [0.5, 0.25, 0.125]
    assert model.specular_roughness.value == 0
    assert model.specular_ior == 1.25
    assert model.transmission_weight.value == 1
    assert model.transmission_color.value == [0.75, 0.5, 0.25]
    assert model.coat_weight.value == 0.25
    assert model.coat_roughness.value == 0.5
    assert model.coat_ior == 1.75
    assert model.coat_darkening.value == 0.125
    assert model.geometry_opacity.value == 0.875
    assert model.geometry_thin_walled
    assert material(contents).emission.value == [1, 2, 0.5]
    assert contents.warnings == ()


def test_phong(build: StageBuilder) -> None:
    bound(build, "EtenduePhong", reflectance=(0.25, 0.5, 0.75), exponent=7.5, form="classic")
    contents = build.read()
    model = material(contents).model
    assert isinstance(model, _core.PhongMaterial)
    assert model.reflectance.value == [0.25, 0.5, 0.75]
    assert model.exponent.value == 7.5
    assert model.form == _core.PhongForm.Classic
    assert contents.warnings == ()


def test_phong_of_unknown_form_is_modified(build: StageBuilder) -> None:
    bound(build, "EtenduePhong", form="blinn")
    contents = build.read()
    model = material(contents).model
    assert isinstance(model, _core.PhongMaterial)
    assert model.form == _core.PhongForm.Modified
    assert "unknown form 'blinn'" in warning_texts(contents)


def test_open_pbr_emission_is_off_by_default(build: StageBuilder) -> None:
    bound(build, OPEN_PBR, emission_color=(1.0, 1.0, 1.0))
    assert material(build.read()).emission.value == [0, 0, 0]


def test_open_pbr_absorption(build: StageBuilder) -> None:
    color = (0.8, 0.6, 0.4)
    bound(build, OPEN_PBR, transmission_color=color, transmission_depth=2.5)
    contents = build.read()
    model = open_pbr(contents)
    assert model.transmission_color.value == pytest.approx(list(color))
    assert model.transmission_depth == 2.5
    assert contents.warnings == ()


@pytest.mark.parametrize(
    ("inputs", "warned"),
    [
        ({"transmission_weight": 1.0}, True),
        ({"transmission_weight": 1.0, "geometry_thin_walled": True}, False),
        ({}, False),
    ],
)
def test_open_pbr_textured_absorption(
    build: StageBuilder, picture: Path, inputs: dict[str, Any], warned: bool
) -> None:
    surface = bound(build, OPEN_PBR, transmission_depth=2.5, **inputs)
    image = build.node("ND_image_color3", "/Material/Image", file=Sdf.AssetPath(str(picture)))
    surface.CreateInput("transmission_color", Types.Color3f).ConnectToSource(
        image.CreateOutput("out", Types.Color3f)
    )
    assert ("textured transmission_color" in warning_texts(build.read())) == warned


def test_open_pbr_unsupported_inputs(build: StageBuilder) -> None:
    for path in ("/A", "/B"):
        build.material(
            OPEN_PBR,
            path,
            coat_weight=0.5,
            coat_color=(1.0, 0.5, 0.0),
            geometry_coat_normal=(0.6, 0.0, 0.8),
            thin_film_weight=0.0,
            transmission_scatter=(0.1, 0.0, 0.0),
            fuzz_color=(1.0, 0.0, 0.0),
            subsurface_weight=0.5,
        )
        build.bind(build.quad(f"{path}Quad"), UsdShade.Material(build.stage.GetPrimAtPath(path)))
    contents = build.read()
    assert [(warning.path, warning.count) for warning in contents.warnings] == [
        ("/A/Surface", 2)
    ] * 4
    text = warning_texts(contents)
    assert "'transmission_scatter' is not supported; rendered without it" in text
    assert "'coat_color' is not supported; rendered without it" in text
    assert "'geometry_coat_normal'" in text
    assert "'subsurface_weight'" in text


def test_open_pbr_coat_inputs_mean_nothing_without_a_coat(build: StageBuilder) -> None:
    coat = {"coat_color": (1.0, 0.5, 0.0), "geometry_coat_normal": (0.6, 0.0, 0.8)}
    bound(build, OPEN_PBR, coat_roughness=0.5, **coat)
    contents = build.read()
    assert open_pbr(contents).coat_roughness.value == 0.5
    assert contents.warnings == ()


def test_mtlx_output_comes_first(build: StageBuilder) -> None:
    shared = build.material()
    node = build.node(OPEN_PBR, "/Material/OpenPbr")
    shared.CreateSurfaceOutput("mtlx").ConnectToSource(node.CreateOutput("out", Types.Token))
    build.bind(build.quad(), shared)
    open_pbr(build.read())


def test_known_universal_output_stands_in_for_an_unknown_one(build: StageBuilder) -> None:
    shared = build.material()
    node = build.node("ND_standard_surface_surfaceshader", "/Material/Standard")
    shared.CreateSurfaceOutput("mtlx").ConnectToSource(node.CreateOutput("out", Types.Token))
    build.bind(build.quad(), shared)
    contents = build.read()
    preview(contents)
    assert contents.warnings == ()


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


# --------------------------------------------------------------------------------------- textures


def test_uv_texture(build: StageBuilder, picture: Path) -> None:
    textured(
        build,
        picture,
        wrapS="repeat",
        wrapT="mirror",
        scale=(0.5, 0.25, 0.125, 1.0),
        bias=(0.5, 0.0, 0.0, 0.0),
        fallback=(1.0, 0.0, 0.0, 1.0),
        sourceColorSpace="raw",
    )
    contents = build.read()
    diffuse = preview(contents).diffuse_color
    (texture,) = contents.scene.textures
    assert diffuse.texture == 0
    assert texture.file == str(picture)
    assert texture.name == "/Material/Texture"
    assert texture.wrap_s == _core.TextureWrap.Repeat
    assert texture.wrap_t == _core.TextureWrap.Mirror
    assert texture.scale == [0.5, 0.25, 0.125, 1]
    assert texture.bias == [0.5, 0, 0, 0]
    assert texture.fallback == [1, 0, 0, 1]
    assert texture.color_space == _core.TextureColorSpace.Raw
    assert texture.st_transform == [1, 0, 0, 0, 1, 0]
    assert contents.warnings == ()


def test_uv_texture_defaults(build: StageBuilder, picture: Path) -> None:
    textured(build, picture)
    (texture,) = build.read().scene.textures
    assert texture.wrap_s == _core.TextureWrap.UseMetadata
    assert texture.color_space == _core.TextureColorSpace.Auto
    assert texture.fallback == [0, 0, 0, 1]


@pytest.mark.parametrize(("output", "channel"), [("r", 0), ("g", 1), ("b", 2), ("a", 3)])
def test_channels(build: StageBuilder, picture: Path, output: str, channel: int) -> None:
    textured(build, picture, output, "roughness")
    roughness = preview(build.read()).roughness
    assert (roughness.texture, roughness.channel) == (0, channel)


def test_texture_is_shared_by_inputs(build: StageBuilder, picture: Path) -> None:
    node = textured(build, picture)
    surface = UsdShade.Shader(build.stage.GetPrimAtPath("/Material/Surface"))
    surface.CreateInput("opacity", Types.Float).ConnectToSource(node.CreateOutput("a", Types.Float))
    contents = build.read()
    assert len(contents.scene.textures) == 1
    assert preview(contents).opacity.channel == 3


def test_path_relative_to_the_authoring_layer(tmp_path: Path) -> None:
    (tmp_path / "looks" / "maps").mkdir(parents=True)
    (tmp_path / "looks" / "maps" / "a.png").touch()
    looks = StageBuilder(Usd.Stage.CreateNew(str(tmp_path / "looks" / "looks.usda")))
    looks.stage.DefinePrim("/Look")
    looks.quad("/Look/Quad")
    looks.material(path="/Look/Material")
    node = looks.node("UsdUVTexture", "/Look/Texture", file=Sdf.AssetPath("./maps/a.png"))
    surface = UsdShade.Shader(looks.stage.GetPrimAtPath("/Look/Material/Surface"))
    surface.CreateInput("diffuseColor", Types.Color3f).ConnectToSource(
        node.CreateOutput("rgb", Types.Float3)
    )
    looks.bind(
        looks.stage.GetPrimAtPath("/Look/Quad"),
        UsdShade.Material(looks.stage.GetPrimAtPath("/Look/Material")),
    )
    looks.stage.Save()
    shot = StageBuilder(Usd.Stage.CreateNew(str(tmp_path / "shot.usda")))
    shot.stage.DefinePrim("/Set").GetReferences().AddReference("looks/looks.usda", "/Look")
    (texture,) = shot.read().scene.textures
    assert texture.file == str(tmp_path / "looks" / "maps" / "a.png")


def test_udim_passes_through(tmp_path: Path) -> None:
    (tmp_path / "a.1001.png").touch()
    build = StageBuilder(Usd.Stage.CreateNew(str(tmp_path / "a.usda")))
    textured(build, "./a.<UDIM>.png")
    (texture,) = build.read().scene.textures
    assert texture.file == str(tmp_path / "a.<UDIM>.png")


def test_missing_texture(build: StageBuilder) -> None:
    textured(build, "nowhere/missing.png", fallback=(0.25, 0.5, 0.75, 1.0))
    contents = build.read()
    assert contents.scene.textures == []
    assert preview(contents).diffuse_color.value == [0.25, 0.5, 0.75]
    assert warning_texts(contents) == (
        "/Material/Texture: texture file 'nowhere/missing.png' is not found; "
        "the texture's fallback colour is used"
    )


def test_texture_without_file(build: StageBuilder) -> None:
    textured(build, "")
    assert "/Material/Texture: the texture names no file" in warning_texts(build.read())


def test_texture_in_a_package(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(b"the picture")
    build = StageBuilder(Usd.Stage.CreateNew(str(tmp_path / "a.usda")))
    textured(build, "./a.png")
    build.stage.Save()
    package = tmp_path / "a.usdz"
    assert UsdUtils.CreateNewUsdzPackage(str(tmp_path / "a.usda"), str(package))
    assert zipfile.is_zipfile(package)
    contents = StageBuilder(Usd.Stage.Open(str(package))).read()
    (texture,) = contents.scene.textures
    assert Path(texture.file).read_bytes() == b"the picture"
    assert Path(texture.file).suffix == ".png"


def test_normal_map_is_never_srgb(build: StageBuilder, picture: Path) -> None:
    textured(
        build,
        picture,
        name="normal",
        scale=(2.0, 2.0, 2.0, 1.0),
        bias=(-1.0, -1.0, -1.0, 0.0),
    )
    contents = build.read()
    (texture,) = contents.scene.textures
    assert material(contents).normal_texture == 0
    assert texture.color_space == _core.TextureColorSpace.Raw
    assert texture.scale == [2, 2, 2, 1]


# ----------------------------------------------------------------------------- texture coordinates


def test_named_coordinates(build: StageBuilder, picture: Path) -> None:
    reader = build.node("UsdPrimvarReader_float2", "/Material/Reader", varname="map1")
    textured(build, picture, st=reader.CreateOutput("result", Types.Float2))
    mesh = UsdGeom.Mesh(build.stage.GetPrimAtPath("/Quad"))
    for name, value in (("st", 0.25), ("map1", 0.75)):
        primvar = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(name, Types.TexCoord2fArray, "vertex")
        primvar.Set([(value, value)] * 4)
    (read,) = build.read().scene.geometries
    assert isinstance(read, _core.MeshDesc)
    np.testing.assert_array_equal(read.st, [[0.75, 0.75]] * 4)


def test_coordinates_named_by_the_interface(build: StageBuilder, picture: Path) -> None:
    reader = build.node("UsdPrimvarReader_float2", "/Material/Reader")
    textured(build, picture, st=reader.CreateOutput("result", Types.Float2))
    interface = UsdShade.Material(build.stage.GetPrimAtPath("/Material")).CreateInput(
        "frame:stPrimvarName", Types.Token
    )
    interface.Set("map1")
    reader.CreateInput("varname", Types.Token).ConnectToSource(interface)
    mesh = UsdGeom.Mesh(build.stage.GetPrimAtPath("/Quad"))
    primvar = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("map1", Types.TexCoord2fArray, "vertex")
    primvar.Set([(0.5, 0.5)] * 4)
    (read,) = build.read().scene.geometries
    assert isinstance(read, _core.MeshDesc)
    assert read.st.shape == (4, 2)


def test_transform_2d(build: StageBuilder, picture: Path) -> None:
    reader = build.node("UsdPrimvarReader_float2", "/Material/Reader", varname="st")
    transform = build.node(
        "UsdTransform2d",
        "/Material/Transform",
        rotation=90.0,
        scale=(2.0, 3.0),
        translation=(0.5, 0.25),
        **{"in": reader.CreateOutput("result", Types.Float2)},
    )
    textured(build, picture, st=transform.CreateOutput("result", Types.Float2))
    (texture,) = build.read().scene.textures
    m = texture.st_transform
    s, t = 0.1, 0.2
    # Scaled to (0.2, 0.6), rotated to (-0.6, 0.2), translated.
    assert m[0] * s + m[1] * t + m[2] == pytest.approx(-0.6 + 0.5)
    assert m[3] * s + m[4] * t + m[5] == pytest.approx(0.2 + 0.25)


def test_two_sets_of_coordinates_warn(build: StageBuilder, picture: Path) -> None:
    textured(build, picture)
    other = build.node("UsdPrimvarReader_float2", "/Material/Other", varname="map1")
    node = build.node(
        "UsdUVTexture",
        "/Material/Texture2",
        file=Sdf.AssetPath(str(picture)),
        st=other.CreateOutput("result", Types.Float2),
    )
    surface = UsdShade.Shader(build.stage.GetPrimAtPath("/Material/Surface"))
    surface.CreateInput("roughness", Types.Float).ConnectToSource(
        node.CreateOutput("r", Types.Float)
    )
    assert "/Material: one set of texture coordinates" in warning_texts(build.read())


def test_primvar_reader_falls_back(build: StageBuilder) -> None:
    surface = bound(build)
    reader = build.node(
        "UsdPrimvarReader_float3",
        "/Material/Reader",
        varname="displayColor",
        fallback=(0.25, 0.5, 0.75),
    )
    surface.CreateInput("diffuseColor", Types.Color3f).ConnectToSource(
        reader.CreateOutput("result", Types.Float3)
    )
    contents = build.read()
    assert preview(contents).diffuse_color.value == [0.25, 0.5, 0.75]
    assert "/Material/Reader: input 'diffuseColor' reads a primvar" in warning_texts(contents)


def test_unknown_input_node(build: StageBuilder) -> None:
    surface = bound(build, OPEN_PBR)
    noise = build.node("ND_noise3d_color3", "/Material/Noise")
    surface.CreateInput("base_color", Types.Color3f).ConnectToSource(
        noise.CreateOutput("out", Types.Color3f)
    )
    contents = build.read()
    assert open_pbr(contents).base_color.value == [0.8, 0.8, 0.8]
    assert "/Material/Noise: node 'ND_noise3d_color3' is not supported" in warning_texts(contents)


# -------------------------------------------------------------------------------- MaterialX images


def test_materialx_image(build: StageBuilder, picture: Path) -> None:
    surface = bound(build, OPEN_PBR)
    image = build.node(
        "ND_tiledimage_color3",
        "/Material/Image",
        file=Sdf.AssetPath(str(picture)),
        uvtiling=(4.0, 2.0),
        default=(0.25, 0.5, 0.75),
    )
    image.GetInput("file").GetAttr().SetColorSpace("srgb_texture")
    surface.CreateInput("base_color", Types.Color3f).ConnectToSource(
        image.CreateOutput("out", Types.Color3f)
    )
    contents = build.read()
    (texture,) = contents.scene.textures
    assert open_pbr(contents).base_color.texture == 0
    assert texture.color_space == _core.TextureColorSpace.Srgb
    assert texture.wrap_s == _core.TextureWrap.Repeat
    assert texture.fallback == [0.25, 0.5, 0.75, 1]
    assert texture.st_transform == [4, 0, 0, 0, 2, 0]
    assert contents.warnings == ()


@pytest.mark.parametrize("coat", [0.0, 0.5])
def test_materialx_normal_map(build: StageBuilder, picture: Path, coat: float) -> None:
    surface = bound(build, OPEN_PBR, coat_weight=coat)
    image = build.node("ND_image_vector3", "/Material/Image", file=Sdf.AssetPath(str(picture)))
    normal = build.node(
        "ND_normalmap", "/Material/Normal", **{"in": image.CreateOutput("out", Types.Vector3f)}
    )
    surface.CreateInput("geometry_normal", Types.Vector3f).ConnectToSource(
        normal.CreateOutput("out", Types.Vector3f)
    )
    contents = build.read()
    (texture,) = contents.scene.textures
    assert material(contents).normal_texture == 0
    assert texture.scale[:3] == [2, 2, 2]
    assert texture.bias[:3] == [-1, -1, -1]
    assert texture.color_space == _core.TextureColorSpace.Raw
    assert ("bumps the coat as well" in warning_texts(contents)) == (coat > 0)


def test_emission_texture_is_scaled_by_the_luminance(build: StageBuilder, picture: Path) -> None:
    surface = bound(build, OPEN_PBR, emission_luminance=100.0)
    image = build.node("ND_image_color3", "/Material/Image", file=Sdf.AssetPath(str(picture)))
    surface.CreateInput("emission_color", Types.Color3f).ConnectToSource(
        image.CreateOutput("out", Types.Color3f)
    )
    contents = build.read()
    assert material(contents).emission.texture == 0
    assert contents.scene.textures[0].scale == [100, 100, 100, 1]


def test_constant_node(build: StageBuilder) -> None:
    surface = bound(build, OPEN_PBR)
    constant = build.node("ND_constant_color3", "/Material/Constant", value=(0.25, 0.5, 0.75))
    surface.CreateInput("base_color", Types.Color3f).ConnectToSource(
        constant.CreateOutput("out", Types.Color3f)
    )
    assert open_pbr(build.read()).base_color.value == [0.25, 0.5, 0.75]


def test_constant_coordinates(build: StageBuilder, picture: Path) -> None:
    textured(build, picture, st=(0.25, 0.75))
    assert build.read().scene.textures[0].st_transform == [0, 0, 0.25, 0, 0, 0.75]


def test_rotation_in_degrees(build: StageBuilder, picture: Path) -> None:
    transform = build.node("UsdTransform2d", "/Material/Transform", rotation=30.0)
    textured(build, picture, st=transform.CreateOutput("result", Types.Float2))
    assert build.read().scene.textures[0].st_transform[0] == pytest.approx(
        math.cos(math.radians(30))
    )
