"""Kinds of prims, in small stages, through Hydra and through the stage reader."""

from __future__ import annotations

from pathlib import Path

import pytest
from pxr import Gf, Sdf, Usd, UsdGeom, UsdLux, UsdShade

import etendue
from support.hydra_host import SCENE_INDEX, HydraHost
from support.path_order import open_in_path_order
from support.same_picture import assert_same_picture, read_color, rgb
from support.stage_builder import StageBuilder

SKY = Sdf.AssetPath(
    str(Path(__file__).resolve().parents[2] / "stages" / "textures" / "sundial.hdr")
)
WIDTH = 64
SAMPLES = 4
ENVIRONMENTS = pytest.mark.parametrize(
    "environment", [{}, SCENE_INDEX], ids=["delegates", "indices"]
)


class Studio(StageBuilder):
    """A floor of 8 x 8 under a lamp, seen from the front."""

    def __init__(self) -> None:
        super().__init__(Usd.Stage.CreateInMemory())
        UsdGeom.SetStageUpAxis(self.stage, "Y")
        floor = self.quad("/Floor")
        floor.GetPointsAttr().Set([(-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4)])
        floor.CreateDisplayColorAttr([(0.6, 0.6, 0.6)])
        lamp = UsdLux.RectLight.Define(self.stage, "/Lamp")
        lamp.CreateIntensityAttr(20)
        UsdGeom.XformCommonAPI(lamp).SetTranslate((0, 5, 1))
        UsdGeom.XformCommonAPI(lamp).SetRotate((-90, 0, 0))
        camera = UsdGeom.Camera.Define(self.stage, "/Camera")
        camera.CreateHorizontalApertureAttr(36)
        camera.CreateVerticalApertureAttr(24)
        camera.CreateFocalLengthAttr(30)
        UsdGeom.XformCommonAPI(camera).SetTranslate((0, 2, 7))
        UsdGeom.XformCommonAPI(camera).SetRotate((-12, 0, 0))

    def box(self, path: str) -> UsdGeom.Mesh:
        """Half a box: two faces that meet at an edge."""
        mesh = UsdGeom.Mesh.Define(self.stage, path)
        mesh.CreateSubdivisionSchemeAttr("none")
        mesh.CreatePointsAttr([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, -1), (0, 1, -1)])
        mesh.CreateFaceVertexCountsAttr([4, 4])
        mesh.CreateFaceVertexIndicesAttr([0, 1, 2, 3, 4, 0, 3, 5])
        return mesh

    def colored(self, path: str, color: tuple[float, float, float]) -> UsdShade.Material:
        """Diffuse of that colour."""
        return self.material(path=path, diffuseColor=Gf.Vec3f(*color))


def assert_parity(
    host: HydraHost, studio: StageBuilder, folder: Path, environment: dict[str, str]
) -> None:
    """Both pictures of the stage are the same."""
    file, output = folder / "stage.usda", folder / "out.exr"
    studio.stage.GetRootLayer().Export(str(file))
    told = {"HDETENDUE_SAMPLES_PER_PIXEL": str(SAMPLES), **environment}
    host.run("record", file, "/Camera", WIDTH, output, environment=told)
    ours = read_color(output)
    size = (ours.shape[1], ours.shape[0])
    stage = etendue.open(open_in_path_order(file))
    assert_same_picture(ours, rgb(stage.render(camera="/Camera", spp=SAMPLES, resolution=size)))


@ENVIRONMENTS
def test_nested_point_instancers(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    inner = UsdGeom.PointInstancer.Define(studio.stage, "/Outer/Inner")
    studio.box("/Outer/Inner/Box")
    UsdGeom.XformCommonAPI(studio.stage.GetPrimAtPath("/Outer/Inner/Box")).SetTranslate((0, 0, 1))
    inner.CreatePrototypesRel().SetTargets(["/Outer/Inner/Box"])
    inner.CreateProtoIndicesAttr([0, 0])
    inner.CreatePositionsAttr([(-1, 0, 0), (1, 0, 0)])
    inner.CreateScalesAttr([(0.5, 0.5, 0.5), (0.5, 1, 0.5)])
    turn = Gf.Rotation((0, 1, 0), 40).GetQuat()
    inner.CreateOrientationsAttr([Gf.Quath(1), Gf.Quath(turn)])
    outer = UsdGeom.PointInstancer.Define(studio.stage, "/Outer")
    outer.CreatePrototypesRel().SetTargets(["/Outer/Inner"])
    outer.CreateProtoIndicesAttr([0, 0, 0])
    outer.CreatePositionsAttr([(-2, 0, 0), (1, 0, -1), (0, 1, 1)])
    outer.CreateInvisibleIdsAttr([2])
    UsdGeom.XformCommonAPI(outer).SetRotate((0, 20, 0))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_native_instances(host: HydraHost, tmp_path: Path, environment: dict[str, str]) -> None:
    studio = Studio()
    studio.stage.CreateClassPrim("/Class")
    studio.box("/Class/Box").CreateDisplayColorAttr([(0.2, 0.4, 0.8)])
    for index in range(3):
        place = UsdGeom.Xform.Define(studio.stage, f"/Copy{index}")
        place.GetPrim().GetReferences().AddInternalReference("/Class")
        place.GetPrim().SetInstanceable(True)
        UsdGeom.XformCommonAPI(place).SetTranslate((2 * index - 2.5, 0, -index))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_subsets_and_their_materials(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    mesh = studio.box("/Box")
    binding = UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim())
    binding.Bind(studio.colored("/Red", (0.8, 0.1, 0.1)))
    subset = binding.CreateMaterialBindSubset("Side", [1])
    side = UsdShade.MaterialBindingAPI.Apply(subset.GetPrim())
    side.Bind(studio.colored("/Blue", (0.1, 0.1, 0.8)))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_normals_and_a_left_handed_mesh_with_a_hole(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    strip = studio.strip()
    strip.CreateOrientationAttr("leftHanded")
    strip.CreateHoleIndicesAttr([1])
    strip.CreateNormalsAttr([(0, 0.3, 1)] * 6 + [(0.4, 0, 1)] * 6)
    strip.SetNormalsInterpolation("faceVarying")
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_a_subdivision_mesh_without_normals(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    studio.box("/Box").GetSubdivisionSchemeAttr().Set("catmullClark")
    with pytest.warns(etendue.EtendueWarning, match="catmullClark"):
        assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
@pytest.mark.parametrize(
    ("kind", "attributes"),
    [
        ("DiskLight", {"inputs:radius": 1.0, "inputs:normalize": True}),
        ("SphereLight", {"inputs:radius": 0.3, "inputs:exposure": 1.0}),
        ("SphereLight", {"inputs:radius": 0.3, "treatAsPoint": True}),
        ("CylinderLight", {"inputs:length": 2.0, "inputs:radius": 0.2}),
        ("DistantLight", {"inputs:angle": 5.0, "inputs:intensity": 200.0}),
        ("DomeLight", {"inputs:texture:file": SKY, "inputs:color": Gf.Vec3f(0.5, 0.7, 1.0)}),
        ("DomeLight_1", {"inputs:texture:file": SKY, "poleAxis": "Z"}),
        (
            "RectLight",
            {"inputs:enableColorTemperature": True, "inputs:colorTemperature": 3000.0},
        ),
    ],
)
def test_lights(
    host: HydraHost,
    tmp_path: Path,
    environment: dict[str, str],
    kind: str,
    attributes: dict[str, object],
) -> None:
    studio = Studio()
    light = studio.stage.DefinePrim("/Another", kind)
    light.GetAttribute("inputs:intensity").Set(10.0)
    for name, value in attributes.items():
        light.GetAttribute(name).Set(value)
    UsdGeom.XformCommonAPI(light).SetTranslate((-1, 2, 0))
    UsdGeom.XformCommonAPI(light).SetRotate((-70, 0, 10))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
@pytest.mark.parametrize("mode", ["noMaterialResponse", "independent", "materialGlowTintsLight"])
def test_mesh_lights(
    host: HydraHost, tmp_path: Path, environment: dict[str, str], mode: str
) -> None:
    studio = Studio()
    for name in ("Above", "Box"):  # on either side of the lamp
        mesh = studio.box(f"/{name}")
        light = UsdLux.MeshLightAPI.Apply(mesh.GetPrim())
        lux = UsdLux.LightAPI(light.GetPrim())
        lux.CreateIntensityAttr(3)
        lux.GetMaterialSyncModeAttr().Set(mode)
        glow = studio.material(
            path=f"/Glow{name}", emissiveColor=Gf.Vec3f(1, 0.5, 0.2), diffuseColor=Gf.Vec3f(0.3)
        )
        UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(glow)
    UsdGeom.XformCommonAPI(studio.stage.GetPrimAtPath("/Above")).SetTranslate((-2, 1, 0))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_instanced_lights(host: HydraHost, tmp_path: Path, environment: dict[str, str]) -> None:
    studio = Studio()
    instancer = UsdGeom.PointInstancer.Define(studio.stage, "/Lamps")
    lamp = UsdLux.SphereLight.Define(studio.stage, "/Lamps/Lamp/Light")
    lamp.CreateRadiusAttr(0.2)
    lamp.CreateIntensityAttr(30)
    UsdGeom.XformCommonAPI(lamp).SetTranslate((0, 1, 0))
    instancer.CreatePrototypesRel().SetTargets(["/Lamps/Lamp"])
    instancer.CreateProtoIndicesAttr([0, 0])
    instancer.CreatePositionsAttr([(-2, 0, 0), (2, 0, -1)])
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_a_shaped_light(host: HydraHost, tmp_path: Path, environment: dict[str, str]) -> None:
    studio = Studio()
    light = studio.light("SphereLight", "/Spot", radius=0.2, intensity=300.0)
    UsdGeom.XformCommonAPI(light).SetRotate((-90, 0, 0))
    shaping = UsdLux.ShapingAPI.Apply(light)
    shaping.CreateShapingConeAngleAttr(25)
    shaping.CreateShapingConeSoftnessAttr(0.3)
    shaping.CreateShapingFocusAttr(2)
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_an_orthographic_camera_with_offsets_and_exposure(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    studio.box("/Box")
    camera = UsdGeom.Camera.Get(studio.stage, "/Camera")
    camera.CreateProjectionAttr("orthographic")
    camera.CreateHorizontalApertureAttr(60)
    camera.CreateVerticalApertureAttr(40)
    camera.CreateHorizontalApertureOffsetAttr(6)
    camera.CreateExposureAttr(-1)
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_a_lens(host: HydraHost, tmp_path: Path, environment: dict[str, str]) -> None:
    studio = Studio()
    studio.box("/Box")
    camera = UsdGeom.Camera.Get(studio.stage, "/Camera")
    camera.CreateFStopAttr(0.5)
    camera.CreateFocusDistanceAttr(5)
    camera.CreateExposureIsoAttr(200)
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
@pytest.mark.parametrize("context", ["", "mtlx"])
def test_a_texture_with_coordinates_of_another_name(
    host: HydraHost, tmp_path: Path, environment: dict[str, str], context: str
) -> None:
    studio = Studio()
    mesh = studio.box("/Box")
    coordinates = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(
        "map2", Sdf.ValueTypeNames.TexCoord2fArray, "faceVarying"
    )
    coordinates.Set([(0, 0), (1, 0), (1, 1), (0, 1)])
    coordinates.SetIndices([0, 1, 2, 3, 3, 2, 1, 0])
    material = (usd_textured if context == "" else mtlx_textured)(studio)
    UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(material)
    assert_parity(host, studio, tmp_path, environment)


def usd_textured(studio: Studio) -> UsdShade.Material:
    """UsdPreviewSurface, UsdUVTexture, UsdTransform2d and a primvar reader."""
    reader = studio.node("UsdPrimvarReader_float2", "/Coordinates", varname="map2")
    place = studio.node(
        "UsdTransform2d",
        "/Place",
        rotation=30.0,
        **{"in": reader.CreateOutput("result", Sdf.ValueTypeNames.Float2)},
    )
    image = studio.node(
        "UsdUVTexture",
        "/Image",
        file=SKY,
        wrapS="repeat",
        wrapT="mirror",
        scale=Gf.Vec4f(0.5, 0.5, 0.5, 1),
        st=place.CreateOutput("result", Sdf.ValueTypeNames.Float2),
    )
    return studio.material(diffuseColor=image.CreateOutput("rgb", Sdf.ValueTypeNames.Float3))


def mtlx_textured(studio: Studio) -> UsdShade.Material:
    """OpenPBR with MaterialX's nodes."""
    reader = studio.node("ND_geompropvalue_vector2", "/Coordinates", geomprop="map2")
    image = studio.node(
        "ND_image_color3",
        "/Image",
        file=SKY,
        texcoord=reader.CreateOutput("out", Sdf.ValueTypeNames.Float2),
    )
    return studio.material(
        "ND_open_pbr_surface_surfaceshader",
        context="mtlx",
        base_color=image.CreateOutput("out", Sdf.ValueTypeNames.Color3f),
        specular_roughness=0.4,
    )
