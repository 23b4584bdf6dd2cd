"""Textures and their coordinates."""

from __future__ import annotations

import math
import zipfile
from pathlib import Path

import numpy as np
import pytest
from pxr import Sdf, Usd, UsdGeom, UsdShade, UsdUtils

from etendue import _core
from support.bound_materials import OPEN_PBR, bound, material, open_pbr, preview, textured
from support.stage_builder import StageBuilder, Types, warning_texts

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


# ---------------------------------------------------------------------------------------- rings


def test_ring_of_texture_transforms(build: StageBuilder, picture: Path) -> None:
    """Two that move each other, behind one that is outside of the ring."""
    textured(build, picture)
    outputs = [
        build.node("UsdTransform2d", f"/Material/{name}", scale=(2.0, 2.0)).CreateOutput(
            "result", Types.Float2
        )
        for name in ("Outer", "One", "Two")
    ]
    texture = UsdShade.Shader(build.stage.GetPrimAtPath("/Material/Texture"))
    texture.CreateInput("st", Types.Float2).ConnectToSource(outputs[0])
    for reader, source in (("Outer", 1), ("One", 2), ("Two", 1)):
        node = UsdShade.Shader(build.stage.GetPrimAtPath(f"/Material/{reader}"))
        node.CreateInput("in", Types.Float2).ConnectToSource(outputs[source])
    contents = build.read()
    (desc,) = contents.scene.textures
    assert desc.st_transform == [1, 0, 0, 0, 1, 0]
    assert (
        "/Material/One: the nodes of texture coordinates feed each other in a ring; "
        "primvar 'st' is used"
    ) in warning_texts(contents)


@pytest.mark.parametrize(
    ("node", "passed_on"),
    [
        ("ND_constant_color3", "value"),
        ("UsdPrimvarReader_float3", "fallback"),
        ("ND_geompropvalue_color3", "default"),
    ],
)
def test_ring_of_constants(build: StageBuilder, node: str, passed_on: str) -> None:
    one, two = (build.node(node, f"/Material/{name}") for name in ("One", "Two"))
    first, second = (each.CreateOutput("out", Types.Color3f) for each in (one, two))
    one.CreateInput(passed_on, Types.Color3f).ConnectToSource(second)
    two.CreateInput(passed_on, Types.Color3f).ConnectToSource(first)
    bound(build).CreateInput("diffuseColor", Types.Color3f).ConnectToSource(first)
    contents = build.read()
    assert preview(contents).diffuse_color.value == [0.18, 0.18, 0.18]
    assert (
        "/Material/One: the nodes of input 'diffuseColor' feed each other in a ring; "
        "its default is used"
    ) in warning_texts(contents)
