"""Native instances and point instancers."""

from __future__ import annotations

import math

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdLux

from etendue import _core
from support.stage_builder import StageBuilder, Types, warning_texts


def instance(build: StageBuilder, path: str, source: str, x: float = 0.0) -> Usd.Prim:
    xform = UsdGeom.Xform.Define(build.stage, path)
    xform.AddTranslateOp().Set((x, 0, 0))
    prim = xform.GetPrim()
    prim.GetReferences().AddInternalReference(source)
    prim.SetInstanceable(True)
    return prim


def asset(build: StageBuilder, path: str = "/Asset") -> str:
    """A quad below a class prim: it is not rendered on its own."""
    build.stage.CreateClassPrim(path)
    build.quad(f"{path}/Quad").AddTranslateOp().Set((0, 1, 0))
    return path


def offsets(scene: _core.SceneDescription) -> list[list[float]]:
    return [item.world_from_group[:3, 3].tolist() for item in scene.instances]


def instancer(
    build: StageBuilder, count: int, path: str = "/Instancer", prototypes: int = 1
) -> UsdGeom.PointInstancer:
    schema = UsdGeom.PointInstancer.Define(build.stage, path)
    targets = [f"{path}/Prototypes/p{index}" for index in range(prototypes)]
    build.stage.OverridePrim(f"{path}/Prototypes")
    for target in targets:
        build.quad(target)
    schema.CreatePrototypesRel().SetTargets([Sdf.Path(target) for target in targets])
    schema.CreateProtoIndicesAttr([index % prototypes for index in range(count)])
    schema.CreatePositionsAttr([(index, 0, 0) for index in range(count)])
    return schema


# ------------------------------------------------------------------------------- native instances


def test_instances_share_a_group(build: StageBuilder) -> None:
    asset(build)
    instance(build, "/A", "/Asset", 1)
    instance(build, "/B", "/Asset", 2)
    scene = build.read().scene
    assert len(scene.geometries) == 1
    assert scene.shapes == []
    (group,) = scene.groups
    (shape,) = group.shapes
    np.testing.assert_array_equal(shape.parent_from_object[:3, 3], [0, 1, 0])
    assert offsets(scene) == [[1, 0, 0], [2, 0, 0]]
    assert [item.group for item in scene.instances] == [0, 0]


def test_nested_instances_are_flattened(build: StageBuilder) -> None:
    asset(build)
    build.stage.CreateClassPrim("/Outer")
    instance(build, "/Outer/Left", "/Asset", 10)
    instance(build, "/Outer/Right", "/Asset", 20)
    build.quad("/Outer/Own")
    instance(build, "/A", "/Outer", 1)
    instance(build, "/B", "/Outer", 2)
    scene = build.read().scene
    assert sorted(len(group.shapes) for group in scene.groups) == [1, 1]
    assert len(scene.instances) == 6
    inner = next(
        index for index, group in enumerate(scene.groups) if "Own" not in group.shapes[0].name
    )
    xs = sorted(item.world_from_group[0, 3] for item in scene.instances if item.group == inner)
    assert xs == [11, 12, 21, 22]


def test_instances_with_other_bindings_do_not_share(build: StageBuilder) -> None:
    asset(build)
    red, blue = build.material(path="/Red"), build.material(path="/Blue")
    build.bind(instance(build, "/A", "/Asset"), red)
    build.bind(instance(build, "/B", "/Asset"), blue)
    build.bind(instance(build, "/C", "/Asset"), blue)
    scene = build.read().scene
    names = [
        scene.materials[scene.groups[item.group].shapes[0].materials[0]].name
        for item in scene.instances
    ]
    assert names == ["/Red", "/Blue", "/Blue"]
    assert len(scene.groups) == 2


def test_instances_with_other_display_colors_do_not_share(build: StageBuilder) -> None:
    asset(build)
    for index, name in enumerate("AB"):
        prim = instance(build, f"/{name}", "/Asset")
        UsdGeom.PrimvarsAPI(prim).CreatePrimvar("displayColor", Types.Color3fArray).Set(
            [(index, 0, 0)]
        )
    scene = build.read().scene
    assert len(scene.groups) == 2
    assert len(scene.materials) == 2


def test_instanceable_mesh(build: StageBuilder) -> None:
    asset(build)
    mesh = UsdGeom.Mesh.Define(build.stage, "/A")
    mesh.GetPrim().GetReferences().AddInternalReference("/Asset/Quad")
    mesh.GetPrim().SetInstanceable(True)
    build.stage.GetPrimAtPath("/Asset/Quad").SetInstanceable(False)
    scene = build.read().scene
    assert sum(len(group.shapes) for group in scene.groups) + len(scene.shapes) == 1


def test_invisible_instance(build: StageBuilder) -> None:
    asset(build)
    instance(build, "/A", "/Asset")
    UsdGeom.Imageable(build.stage.GetPrimAtPath("/A")).MakeInvisible()
    assert build.read().scene.instances == []


def test_lights_inside_instances(build: StageBuilder) -> None:
    build.stage.CreateClassPrim("/Asset")
    build.light("RectLight", "/Asset/Light", intensity=7.0)
    instance(build, "/A", "/Asset", 1)
    instance(build, "/B", "/Asset", 2)
    lights = build.read().scene.lights
    assert [light.world_from_light[0, 3] for light in lights] == [1.5, 2.5]
    assert [light.intensity for light in lights] == [7, 7]


def test_mesh_lights_inside_instances_stand_alone(build: StageBuilder) -> None:
    UsdLux.MeshLightAPI.Apply(build.stage.GetPrimAtPath(f"{asset(build)}/Quad"))
    instance(build, "/A", "/Asset", 1)
    instance(build, "/B", "/Asset", 2)
    scene = build.read().scene
    assert scene.instances == []
    assert len(scene.geometries) == 1
    assert [light.shape for light in scene.lights] == [0, 1]
    assert [shape.parent_from_object[:3, 3].tolist() for shape in scene.shapes] == [
        [1, 1, 0],
        [2, 1, 0],
    ]


# -------------------------------------------------------------------------------- point instancers


def test_point_instancer(build: StageBuilder) -> None:
    schema = instancer(build, 2)
    schema.AddTranslateOp().Set((0, 0, 100))
    build.stage.GetPrimAtPath("/Instancer/Prototypes/p0").GetAttribute("xformOpOrder")
    UsdGeom.Xformable(build.stage.GetPrimAtPath("/Instancer/Prototypes/p0")).AddTranslateOp().Set(
        (0, 1, 0)
    )
    half = math.sqrt(0.5)
    schema.CreateOrientationsAttr([Gf.Quath(1, 0, 0, 0), Gf.Quath(half, 0, 0, half)])
    schema.CreateScalesAttr([(1, 1, 1), (2, 2, 2)])
    scene = build.read().scene
    assert scene.shapes == []
    # The prototype's own transform first, then scale, rotation and position.
    np.testing.assert_allclose(offsets(scene), [[0, 1, 100], [-1, 0, 100]], atol=2e-3)
    np.testing.assert_array_equal(scene.groups[0].shapes[0].parent_from_object, np.eye(4))


def test_newer_orientations_win(build: StageBuilder) -> None:
    schema = instancer(build, 1)
    half = math.sqrt(0.5)
    schema.CreateOrientationsAttr([Gf.Quath(1, 0, 0, 0)])
    schema.CreateOrientationsfAttr([Gf.Quatf(half, 0, 0, half)])
    (item,) = build.read().scene.instances
    np.testing.assert_allclose(item.world_from_group[:3, 0], [0, 1, 0], atol=1e-6)


def test_several_prototypes(build: StageBuilder) -> None:
    instancer(build, 5, prototypes=2)
    scene = build.read().scene
    assert len(scene.groups) == 2
    xs = {
        group: [item.world_from_group[0, 3] for item in scene.instances if item.group == group]
        for group in (0, 1)
    }
    assert xs == {0: [0, 2, 4], 1: [1, 3]}


def test_invisible_and_inactive_ids(build: StageBuilder) -> None:
    schema = instancer(build, 4)
    schema.CreateIdsAttr([10, 11, 12, 13])
    schema.CreateInvisibleIdsAttr([11])
    schema.DeactivateId(12)
    assert [x for x, _, _ in offsets(build.read().scene)] == [0, 3]


def test_all_ids_invisible(build: StageBuilder) -> None:
    instancer(build, 2).CreateInvisibleIdsAttr([0, 1])
    contents = build.read()
    assert contents.scene.instances == []
    assert contents.warnings == ()


def test_prototype_index_out_of_range(build: StageBuilder) -> None:
    instancer(build, 2).GetProtoIndicesAttr().Set([0, 5])
    contents = build.read()
    assert contents.scene.instances == []
    assert "/Instancer: the point instancer is skipped: prototype 5 of 1" in warning_texts(contents)


def test_positions_that_do_not_match(build: StageBuilder) -> None:
    instancer(build, 2).GetPositionsAttr().Set([(0, 0, 0)])
    contents = build.read()
    assert contents.scene.instances == []
    assert "/Instancer: the point instancer is skipped: its positions" in warning_texts(contents)


def test_nested_point_instancer(build: StageBuilder) -> None:
    outer = UsdGeom.PointInstancer.Define(build.stage, "/Outer")
    instancer(build, 2, "/Outer/Inner")
    outer.CreatePrototypesRel().SetTargets([Sdf.Path("/Outer/Inner")])
    outer.CreateProtoIndicesAttr([0, 0, 0])
    outer.CreatePositionsAttr([(0, 10, 0), (0, 20, 0), (0, 30, 0)])
    scene = build.read().scene
    assert len(scene.groups) == 1
    assert sorted((x, y) for x, y, _ in offsets(scene)) == [
        (x, y) for x in (0, 1) for y in (10, 20, 30)
    ]


def test_point_instancer_of_native_instances(build: StageBuilder) -> None:
    asset(build)
    schema = instancer(build, 2)
    instance(build, "/Instancer/Prototypes/native", "/Asset")
    schema.GetPrototypesRel().SetTargets([Sdf.Path("/Instancer/Prototypes/native")])
    scene = build.read().scene
    assert len(scene.groups) == 1
    assert offsets(scene) == [[0, 0, 0], [1, 0, 0]]


def test_point_instancer_inside_native_instances(build: StageBuilder) -> None:
    build.stage.CreateClassPrim("/Asset")
    instancer(build, 2, "/Asset/Instancer")
    instance(build, "/A", "/Asset", 10)
    instance(build, "/B", "/Asset", 20)
    scene = build.read().scene
    assert [x for x, _, _ in offsets(scene)] == [10, 11, 20, 21]


def test_lights_inside_point_instancers(build: StageBuilder) -> None:
    schema = instancer(build, 2)
    build.light("SphereLight", "/Instancer/Prototypes/light")
    schema.GetPrototypesRel().SetTargets([Sdf.Path("/Instancer/Prototypes/light")])
    lights = build.read().scene.lights
    np.testing.assert_allclose(
        [light.world_from_light[:3, 3] for light in lights], [[0.5, 0.5, 8], [1.5, 0.5, 8]]
    )


def test_positions_at_a_frame(build: StageBuilder) -> None:
    positions = instancer(build, 1).GetPositionsAttr()
    positions.Clear()
    positions.Set([(0, 0, 0)], 0.0)
    positions.Set([(4, 0, 0)], 4.0)
    (item,) = build.read(2.0).scene.instances
    assert item.world_from_group[0, 3] == 2
