"""Cameras, RenderSettings and the stage as a whole."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from pxr import Gf, Sdf, Usd, UsdGeom, UsdRender

from etendue import FileError, _core
from etendue.usd_reader import read_stage
from support.stage_builder import StageBuilder, warning_texts


def render_settings(build: StageBuilder) -> UsdRender.Settings:
    settings = UsdRender.Settings.Define(build.stage, "/Render/Settings")
    build.stage.SetMetadata("renderSettingsPrimPath", "/Render/Settings")
    return settings


# ---------------------------------------------------------------------------------------- cameras


def test_camera(build: StageBuilder) -> None:
    camera = build.camera(
        horizontalAperture=36.0,
        verticalAperture=24.0,
        horizontalApertureOffset=1.0,
        verticalApertureOffset=2.0,
        focalLength=35.0,
        fStop=2.8,
        focusDistance=4.0,
    )
    camera.CreateExposureAttr(1.0)
    camera.CreateExposureIsoAttr(200.0)
    contents = build.read()
    (desc,) = contents.scene.cameras
    assert contents.cameras == ("/Camera",)
    assert (desc.horizontal_aperture, desc.vertical_aperture) == (36, 24)
    assert (desc.horizontal_aperture_offset, desc.vertical_aperture_offset) == (1, 2)
    assert desc.focal_length == 35
    assert desc.f_stop == pytest.approx(2.8)
    assert desc.focus_distance == 4
    assert desc.exposure_scale == 4
    np.testing.assert_array_equal(desc.world_from_camera[:3, 3], [0.5, 0.5, 5])


def test_camera_at_a_frame(build: StageBuilder) -> None:
    focal = build.camera().GetFocalLengthAttr()
    focal.Set(20.0, 0.0)
    focal.Set(40.0, 10.0)
    assert build.read(5.0).scene.cameras[0].focal_length == 30


def test_invisible_cameras_count(build: StageBuilder) -> None:
    build.camera().MakeInvisible()
    assert build.read().cameras == ("/Camera",)


def test_orthographic_camera(build: StageBuilder) -> None:
    build.camera("/A", projection="orthographic", horizontalAperture=40.0)
    build.camera("/B")
    contents = build.read()
    assert contents.cameras == ("/A", "/B")
    assert [camera.projection for camera in contents.scene.cameras] == [
        _core.CameraProjection.Orthographic,
        _core.CameraProjection.Perspective,
    ]
    assert contents.scene.cameras[0].horizontal_aperture == 40
    assert contents.warnings == ()


# ----------------------------------------------------------------------------------- RenderSettings


def test_no_render_settings(build: StageBuilder) -> None:
    settings = build.read().settings
    assert settings.path is None
    assert settings.resolution is None


def test_render_settings(build: StageBuilder) -> None:
    build.camera(fStop=2.0, focusDistance=1.0)
    settings = render_settings(build)
    settings.CreateCameraRel().SetTargets([Sdf.Path("/Camera")])
    settings.CreateResolutionAttr(Gf.Vec2i(320, 200))
    settings.CreateAspectRatioConformPolicyAttr("cropAperture")
    settings.CreateDisableDepthOfFieldAttr(True)
    settings.CreateIncludedPurposesAttr(["default", "proxy"])
    build.quad("/Proxy", purpose="proxy")
    build.quad("/Render2", purpose="render")
    contents = build.read()
    assert contents.settings.camera == "/Camera"
    assert contents.settings.resolution == (320, 200)
    assert contents.settings.conform == _core.ApertureConform.CropAperture
    assert contents.scene.cameras[0].f_stop == 0
    assert [shape.name for shape in contents.scene.shapes] == ["/Proxy"]
    assert contents.warnings == ()


def test_product_overrides_what_it_authors(build: StageBuilder) -> None:
    settings = render_settings(build)
    settings.CreateResolutionAttr(Gf.Vec2i(320, 200))
    settings.CreateAspectRatioConformPolicyAttr("cropAperture")
    product = UsdRender.Product.Define(build.stage, "/Render/Product")
    product.CreateResolutionAttr(Gf.Vec2i(64, 32))
    settings.CreateProductsRel().SetTargets([product.GetPath()])
    read = build.read().settings
    assert read.resolution == (64, 32)
    assert read.conform == _core.ApertureConform.CropAperture


def test_pixel_aspect_ratio_warns(build: StageBuilder) -> None:
    render_settings(build).CreatePixelAspectRatioAttr(2.0)
    assert "/Render/Settings: pixels are rendered square" in warning_texts(build.read())


def test_settings_path_that_leads_nowhere(build: StageBuilder) -> None:
    build.stage.SetMetadata("renderSettingsPrimPath", "/Nowhere")
    assert "/Nowhere: is not a RenderSettings prim" in warning_texts(build.read())


# ------------------------------------------------------------------------------------------- files


def test_missing_file(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"missing\.usda: no such file"):
        read_stage(tmp_path / "missing.usda")


def test_directory(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="is a directory"):
        read_stage(tmp_path)


@pytest.mark.parametrize("name", ["a.usda", "a.usdc", "a.usd", "a.txt", "a.usdz"])
def test_file_that_is_no_stage(tmp_path: Path, name: str) -> None:
    file = tmp_path / name
    file.write_text("this is not a stage")
    with pytest.raises(FileError, match=f"{name}: not a USD stage") as caught:
        read_stage(file)
    assert "\n" not in str(caught.value)


def test_truncated_stage(tmp_path: Path) -> None:
    build = StageBuilder()
    build.quad()
    file = tmp_path / "a.usdc"
    build.stage.Export(str(file))
    file.write_bytes(file.read_bytes()[:-200])
    with pytest.raises(FileError, match=r"a\.usdc: not a USD stage"):
        read_stage(file)


def test_missing_reference(tmp_path: Path) -> None:
    file = tmp_path / "a.usda"
    file.write_text('#usda 1.0\ndef "A" (references = @./missing.usda@) {}\n')
    contents = read_stage(file)
    assert "/A: Could not open asset" in warning_texts(contents)
    assert "missing.usda" in warning_texts(contents)


def test_materialx_reference(tmp_path: Path) -> None:
    file = tmp_path / "a.usda"
    (tmp_path / "look.mtlx").write_text("<materialx/>")
    file.write_text('#usda 1.0\ndef "A" (references = @./look.mtlx@) {}\n')
    assert "does not read .mtlx files" in warning_texts(read_stage(file))


def test_empty_stage(build: StageBuilder) -> None:
    contents = build.read()
    assert contents.scene.shapes == []
    assert contents.warnings == ()


def test_source(tmp_path: Path) -> None:
    file = tmp_path / "a.usda"
    Usd.Stage.CreateNew(str(file)).Save()
    assert read_stage(file).scene.source == str(file)
    assert read_stage(str(file)).source == str(file)


def test_deep_namespace(build: StageBuilder) -> None:
    path = "".join(f"/x{depth}" for depth in range(300))
    UsdGeom.Xform.Define(build.stage, "/x0").AddTranslateOp().Set((1, 0, 0))
    build.quad(f"{path}/Quad")
    (shape,) = build.read().scene.shapes
    assert shape.parent_from_object[0, 3] == 1


# What a schema says of an attribute's type binds no file.
WRONG_TYPES = """#usda 1.0
(
    renderSettingsPrimPath = "/Settings"
)
def Camera "Camera"
{
    string focalLength = "long"
}
def SphereLight "Light"
{
    string inputs:intensity = "bright"
    string inputs:color = "red"
}
def Sphere "Ball"
{
    string radius = "big"
    string visibility = "perhaps"
    string purpose = "none"
}
def Mesh "Points"
{
    string points = "here"
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
}
def Mesh "Primvars" (
    prepend apiSchemas = ["MaterialBindingAPI"]
)
{
    rel material:binding = </Material>
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    float primvars:displayColor = 3
    string[] primvars:normals = ["a"]
    uniform token subdivisionScheme = "mystery"
}
def Material "Material"
{
    token outputs:surface.connect = </Material/Surface.outputs:out>
    def Shader "Surface"
    {
        uniform token info:id = "UsdPreviewSurface"
        string inputs:ior = "glass"
        string inputs:diffuseColor = "red"
        token outputs:out
    }
}
def PointInstancer "Instancer"
{
    string protoIndices = "all"
    rel prototypes = </Ball>
}
def RenderSettings "Settings"
{
    string resolution = "high"
}
"""


def test_wrong_types_are_skipped(tmp_path: Path) -> None:
    file = tmp_path / "a.usda"
    file.write_text(WRONG_TYPES)
    contents = read_stage(file)
    assert "/Primvars" in [shape.name for shape in contents.scene.shapes]
    text = warning_texts(contents)
    assert "/Primvars: primvar 'normals' is ignored: its values are not numbers" in text
    assert "/Points: the Mesh is skipped: an attribute has a value of a wrong type" in text
    assert "/Material" in text
    assert all(str(warning).count("\n") == 0 for warning in contents.warnings)
