"""UsdLux lights."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pxr import Sdf, Usd, UsdGeom, UsdLux

from etendue import _core
from support.stage_builder import StageBuilder, Types, warning_texts


def only_light(build: StageBuilder) -> _core.LightDesc:
    (light,) = build.read().scene.lights
    return light


def test_defaults_are_the_schemas(build: StageBuilder) -> None:
    build.light("DistantLight")
    light = only_light(build)
    assert light.kind == _core.LightKind.Distant
    assert light.intensity == 50000
    assert light.angle == pytest.approx(0.53)
    assert light.color == [1, 1, 1]
    assert light.color_temperature_rgb == [1, 1, 1]
    assert not light.normalize


def test_rect(build: StageBuilder) -> None:
    build.light("RectLight", width=2.0, height=3.0, intensity=4.0, exposure=5.0, normalize=True)
    light = only_light(build)
    assert light.kind == _core.LightKind.Rect
    assert (light.width, light.height) == (2, 3)
    assert (light.intensity, light.exposure, light.normalize) == (4, 5, True)
    np.testing.assert_array_equal(light.world_from_light[:3, 3], [0.5, 0.5, 8])
    assert light.name == "/Light"


def test_disk(build: StageBuilder) -> None:
    build.light("DiskLight", radius=2.0)
    light = only_light(build)
    assert (light.kind, light.radius) == (_core.LightKind.Disk, 2)


@pytest.mark.parametrize("point", [False, True])
def test_sphere(build: StageBuilder, point: bool) -> None:
    build.light("SphereLight", radius=0.0).GetAttribute("treatAsPoint").Set(point)
    light = only_light(build)
    assert light.kind == _core.LightKind.Sphere
    assert (light.radius, light.treat_as_point) == (0, point)


@pytest.mark.parametrize("line", [False, True])
def test_cylinder(build: StageBuilder, line: bool) -> None:
    build.light("CylinderLight", length=3.0, radius=0.25).GetAttribute("treatAsLine").Set(line)
    contents = build.read()
    (light,) = contents.scene.lights
    assert light.kind == _core.LightKind.Cylinder
    assert (light.length, light.radius, light.treat_as_line) == (3, 0.25, line)
    assert contents.warnings == ()


def test_rect_texture(build: StageBuilder, sky: Path) -> None:
    prim = build.light("RectLight")
    prim.GetAttribute("inputs:texture:file").Set(Sdf.AssetPath(str(sky)))
    contents = build.read()
    assert contents.scene.lights[0].texture_file == str(sky)
    assert contents.warnings == ()


@pytest.mark.parametrize("kind", ["RectLight", "DomeLight"])
def test_udim_texture_is_left_out(build: StageBuilder, tmp_path: Path, kind: str) -> None:
    (tmp_path / "tile.1001.hdr").touch()
    build.stage.GetRootLayer().Export(str(tmp_path / "stage.usda"))
    build = StageBuilder(Usd.Stage.Open(str(tmp_path / "stage.usda")))
    prim = build.light(kind)
    prim.GetAttribute("inputs:texture:file").Set(Sdf.AssetPath("./tile.<UDIM>.hdr"))
    contents = build.read()
    assert contents.scene.lights[0].texture_file == ""
    assert "/Light: texture file './tile.<UDIM>.hdr' is a UDIM set" in warning_texts(contents)


@pytest.mark.parametrize("kind", ["DomeLight", "DomeLight_1"])
def test_dome(build: StageBuilder, kind: str) -> None:
    build.light(kind, color=(0.25, 0.5, 0.75))
    light = only_light(build)
    assert (light.kind, light.color) == (_core.LightKind.Dome, [0.25, 0.5, 0.75])


def dome(build: StageBuilder, file: Path, kind: str = "DomeLight") -> Usd.Prim:
    """A dome with a texture."""
    prim = build.light(kind)
    prim.GetAttribute("inputs:texture:file").Set(Sdf.AssetPath(str(file)))
    return prim


@pytest.fixture
def sky(tmp_path: Path) -> Path:
    """A file that the reader need not look into."""
    file = tmp_path / "sky.hdr"
    file.touch()
    return file


@pytest.mark.parametrize("kind", ["DomeLight", "DomeLight_1"])
@pytest.mark.parametrize("layout", ["automatic", "latlong"])
def test_dome_texture(build: StageBuilder, sky: Path, kind: str, layout: str) -> None:
    dome(build, sky, kind).GetAttribute("inputs:texture:format").Set(layout)
    contents = build.read()
    (light,) = contents.scene.lights
    assert light.texture_file == str(sky)
    assert light.texture_color_space == _core.TextureColorSpace.Auto
    assert contents.warnings == ()


def test_dome_texture_color_space(build: StageBuilder, sky: Path) -> None:
    dome(build, sky).GetAttribute("inputs:texture:file").SetColorSpace("srgb_rec709_scene")
    assert only_light(build).texture_color_space == _core.TextureColorSpace.Srgb


@pytest.mark.parametrize("layout", ["mirroredBall", "angular", "cubeMapVerticalCross"])
def test_other_texture_formats_are_left_out(build: StageBuilder, sky: Path, layout: str) -> None:
    dome(build, sky).GetAttribute("inputs:texture:format").Set(layout)
    contents = build.read()
    assert contents.scene.lights[0].texture_file == ""
    assert f"/Light: texture:format '{layout}' is not supported" in warning_texts(contents)


def test_missing_dome_texture(build: StageBuilder, tmp_path: Path) -> None:
    dome(build, tmp_path / "nowhere.hdr")
    contents = build.read()
    assert contents.scene.lights[0].texture_file == ""
    assert "nowhere.hdr' is not found; the constant colour is used" in warning_texts(contents)


@pytest.mark.parametrize(
    ("kind", "up", "pole", "expected"),
    [
        ("DomeLight", "Y", None, "Y"),
        ("DomeLight", "Z", None, "Y"),
        ("DomeLight_1", "Y", None, "Y"),
        ("DomeLight_1", "Z", None, "Z"),
        ("DomeLight_1", "Z", "scene", "Z"),
        ("DomeLight_1", "Z", "Y", "Y"),
        ("DomeLight_1", "Y", "Z", "Z"),
    ],
)
def test_pole_axis(
    build: StageBuilder, kind: str, up: str, pole: str | None, expected: str
) -> None:
    UsdGeom.SetStageUpAxis(build.stage, up)
    prim = build.light(kind)
    if pole is not None:
        prim.GetAttribute("poleAxis").Set(pole)
    assert only_light(build).pole_axis.name == expected


def test_color_temperature(build: StageBuilder) -> None:
    build.light(enableColorTemperature=True, colorTemperature=6500.0)
    np.testing.assert_allclose(
        only_light(build).color_temperature_rgb, [1.0433, 0.9836, 1.0346], atol=1e-4
    )


def test_color_temperature_must_be_enabled(build: StageBuilder) -> None:
    build.light(colorTemperature=2000.0)
    assert only_light(build).color_temperature_rgb == [1, 1, 1]


def test_color_space(build: StageBuilder) -> None:
    color = build.light(color=(0.5, 0.5, 0.5)).GetAttribute("inputs:color")
    color.SetColorSpace("srgb_rec709_scene")
    np.testing.assert_allclose(only_light(build).color, [0.21404] * 3, atol=1e-4)


def test_frame(build: StageBuilder) -> None:
    intensity = build.light().GetAttribute("inputs:intensity")
    intensity.Set(1.0, 0.0)
    intensity.Set(3.0, 2.0)
    assert build.read(1.0).scene.lights[0].intensity == 2


def test_visibility_and_purpose(build: StageBuilder) -> None:
    UsdGeom.Imageable(build.light(path="/A")).MakeInvisible()
    UsdGeom.Imageable(build.light(path="/B")).CreatePurposeAttr("proxy")
    assert build.read().scene.lights == []


# ------------------------------------------------------------------------------------ mesh lights


def test_mesh_light(build: StageBuilder) -> None:
    UsdLux.MeshLightAPI.Apply(build.quad().GetPrim())
    build.bind(build.stage.GetPrimAtPath("/Quad"), build.material(emissiveColor=(1.0, 0.5, 0.0)))
    contents = build.read()
    (light,) = contents.scene.lights
    assert (light.kind, light.shape, light.tinted_by_material) == (_core.LightKind.Mesh, 0, True)
    assert contents.scene.shapes[0].name == "/Quad"
    assert contents.warnings == ()


def test_mesh_light_without_glow(build: StageBuilder) -> None:
    UsdLux.MeshLightAPI.Apply(build.quad().GetPrim())
    assert "it emits nothing" in warning_texts(build.read())


def test_independent_mesh_light(build: StageBuilder) -> None:
    prim = build.quad().GetPrim()
    UsdLux.MeshLightAPI.Apply(prim)
    UsdLux.LightAPI(prim).CreateMaterialSyncModeAttr("independent")
    build.bind(prim, build.material())
    scene = build.read().scene
    assert not scene.lights[0].tinted_by_material
    assert scene.materials[scene.shapes[0].materials[0]].name == "/Material"


def test_mesh_light_without_material_response(build: StageBuilder) -> None:
    prim = build.quad().GetPrim()
    UsdLux.MeshLightAPI.Apply(prim)
    UsdLux.LightAPI(prim).CreateMaterialSyncModeAttr("noMaterialResponse")
    build.bind(prim, build.material())
    scene = build.read().scene
    assert not scene.lights[0].tinted_by_material
    black = scene.materials[scene.shapes[0].materials[0]].model
    assert isinstance(black, _core.DiffuseMaterial)
    assert black.reflectance.value == [0, 0, 0]


# ------------------------------------------------------------------------------------ unsupported


@pytest.mark.parametrize("kind", ["PortalLight", "GeometryLight"])
def test_unsupported_kinds_are_skipped(build: StageBuilder, kind: str) -> None:
    build.light(kind, "/A")
    build.light(kind, "/B")
    contents = build.read()
    assert contents.scene.lights == []
    assert warning_texts(contents) == f"/A: {kind} is not supported; skipped (and 1 more)"


def shaping(prim: Usd.Prim, **inputs: Any) -> None:
    UsdLux.ShapingAPI.Apply(prim)
    for name, value in inputs.items():
        prim.GetAttribute(f"inputs:shaping:{name.replace('_', ':')}").Set(value)


def test_shaping_that_is_not_applied_is_none(build: StageBuilder) -> None:
    build.light("SphereLight")
    assert only_light(build).shaping is None


def test_shaping_defaults(build: StageBuilder) -> None:
    shaping(build.light("SphereLight"))
    light = only_light(build)
    assert light.shaping is not None
    assert (light.shaping.cone_angle, light.shaping.cone_softness) == (90, 0)
    assert (light.shaping.focus, light.shaping.focus_tint) == (0, [0, 0, 0])


@pytest.mark.parametrize("kind", ["RectLight", "DiskLight", "SphereLight", "CylinderLight"])
def test_shaping(build: StageBuilder, kind: str) -> None:
    inputs = {"cone_angle": 30.0, "cone_softness": 0.5, "focus": 2.0, "focusTint": (0.25, 0.5, 1)}
    shaping(build.light(kind), **inputs)
    contents = build.read()
    desc = contents.scene.lights[0].shaping
    assert desc is not None
    assert (desc.cone_angle, desc.cone_softness, desc.focus) == (30, 0.5, 2)
    assert desc.focus_tint == [0.25, 0.5, 1]
    assert contents.warnings == ()


@pytest.mark.parametrize("kind", ["DistantLight", "DomeLight"])
def test_shaping_of_infinite_lights(build: StageBuilder, kind: str) -> None:
    shaping(build.light(kind), cone_angle=30.0)
    contents = build.read()
    assert contents.scene.lights[0].shaping is None
    assert f"a {kind} has no shape" in warning_texts(contents)


def test_other_unsupported_inputs_warn_once_per_kind(build: StageBuilder) -> None:
    for path in ("/A", "/B"):
        prim = build.light("RectLight", path, diffuse=0.5, specular=0.5)
        shaping(prim, ies_file=Sdf.AssetPath("lamp.ies"))
        UsdLux.ShadowAPI.Apply(prim).CreateShadowEnableAttr(False)
        light = UsdLux.LightAPI(prim)
        light.CreateFiltersRel().SetTargets([Sdf.Path("/Filter")])
        light.GetLightLinkCollectionAPI().CreateExcludesRel().SetTargets([Sdf.Path("/Quad")])
        light.GetShadowLinkCollectionAPI().CreateIncludeRootAttr(False)
    contents = build.read()
    assert len(contents.scene.lights) == 2
    assert [(warning.path, warning.count) for warning in contents.warnings] == [("/A", 2)] * 7
    text = warning_texts(contents)
    for word in (
        "inputs:diffuse",
        "inputs:specular",
        "light filters",
        "IES",
        "ShadowAPI",
        "lightLink",
        "shadowLink",
    ):
        assert word in text


def test_applied_apis_at_their_defaults_are_silent(build: StageBuilder) -> None:
    UsdLux.ShadowAPI.Apply(build.light("RectLight"))
    assert build.read().warnings == ()


def test_light_with_type_of_its_own(build: StageBuilder) -> None:
    """A light is known by its API: here on a sphere, which is no supported kind of light."""
    prim = UsdGeom.Sphere.Define(build.stage, "/Ball").GetPrim()
    UsdLux.LightAPI.Apply(prim)
    contents = build.read()
    assert contents.scene.lights == []
    assert "/Ball: Sphere is not supported" in warning_texts(contents)


def test_custom_color_space_by_ancestor(build: StageBuilder) -> None:
    build.stage.DefinePrim("/Lights")
    Usd.ColorSpaceAPI.Apply(build.stage.GetPrimAtPath("/Lights"))
    build.stage.GetPrimAtPath("/Lights").CreateAttribute(
        "colorSpace:name", Types.Token, custom=False
    ).Set("lin_ap1_scene")
    build.light(path="/Lights/Light", color=(1.0, 0.0, 0.0))
    light = only_light(build)
    # ACEScg red lies outside of Rec.709.
    np.testing.assert_allclose(light.color, [1.7051, -0.1300, -0.0240], atol=1e-2)


def test_unknown_color_space(build: StageBuilder) -> None:
    color = build.light(color=(0.5, 0.5, 0.5)).GetAttribute("inputs:color")
    color.SetColorSpace("mystery")
    contents = build.read()
    assert contents.scene.lights[0].color == [0.5, 0.5, 0.5]
    assert "unknown colour space 'mystery'" in warning_texts(contents)
