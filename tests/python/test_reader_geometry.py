"""Meshes and implicit solids."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pxr import Sdf, UsdGeom, UsdShade, Vt

from etendue import _core
from etendue.usd_reader import StageContents
from support.stage_builder import StageBuilder, Types, warning_texts


def only_mesh(contents: StageContents) -> _core.MeshDesc:
    (mesh,) = contents.scene.geometries
    assert isinstance(mesh, _core.MeshDesc)
    return mesh


def wear_texture(build: StageBuilder, mesh: UsdGeom.Mesh, picture: Path) -> None:
    """Makes the mesh of something that needs texture coordinates."""
    node = build.node("UsdUVTexture", "/Looks/Texture", file=Sdf.AssetPath(str(picture)))
    color = node.CreateOutput("rgb", Types.Float3)
    build.bind(mesh, build.material(path="/Looks", diffuseColor=color))


def test_polygon_mesh_is_faceted(build: StageBuilder) -> None:
    build.quad()
    contents = build.read()
    mesh = only_mesh(contents)
    assert mesh.points.dtype == np.float32
    np.testing.assert_array_equal(mesh.points[2], [1, 1, 0])
    np.testing.assert_array_equal(mesh.face_vertex_counts, [4])
    np.testing.assert_array_equal(mesh.face_vertex_indices, [0, 1, 2, 3])
    assert mesh.face_vertex_indices.dtype == np.int32
    assert mesh.normals.shape == (0, 3)
    assert not mesh.left_handed
    assert contents.warnings == ()


def test_left_handed(build: StageBuilder) -> None:
    build.quad(orientation="leftHanded")
    assert only_mesh(build.read()).left_handed


def test_points_at_a_frame(build: StageBuilder) -> None:
    points = build.quad().GetPointsAttr()
    points.Clear()
    points.Set([(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], 1.0)
    points.Set([(0, 0, 3), (1, 0, 3), (1, 1, 3), (0, 1, 3)], 3.0)
    assert only_mesh(build.read(2.0)).points[0, 2] == 2.0
    build.stage.SetStartTimeCode(3.0)
    assert only_mesh(build.read()).points[0, 2] == 3.0


def test_transform_is_composed_for_column_vectors(build: StageBuilder) -> None:
    parent = UsdGeom.Xform.Define(build.stage, "/Parent")
    parent.AddTranslateOp().Set((1, 2, 3))
    build.quad("/Parent/Quad").AddScaleOp().Set((2, 2, 2))
    (shape,) = build.read().scene.shapes
    assert shape.name == "/Parent/Quad"
    np.testing.assert_allclose(shape.parent_from_object @ [1, 0, 0, 1], [3, 2, 3, 1])


def test_reset_xform_stack(build: StageBuilder) -> None:
    UsdGeom.Xform.Define(build.stage, "/Parent").AddTranslateOp().Set((1, 2, 3))
    quad = build.quad("/Parent/Quad")
    quad.SetResetXformStack(True)
    (shape,) = build.read().scene.shapes
    np.testing.assert_array_equal(shape.parent_from_object, np.eye(4))


# --------------------------------------------------------------------------------------- primvars


@pytest.mark.parametrize(
    ("token", "count", "interpolation"),
    [
        ("constant", 1, _core.Interpolation.Constant),
        ("uniform", 3, _core.Interpolation.Uniform),
        ("varying", 8, _core.Interpolation.Vertex),
        ("vertex", 8, _core.Interpolation.Vertex),
        ("faceVarying", 12, _core.Interpolation.FaceVarying),
    ],
)
def test_normals_interpolation(
    build: StageBuilder, token: str, count: int, interpolation: _core.Interpolation
) -> None:
    mesh = build.strip()
    mesh.CreateNormalsAttr([(0, 0, 1)] * count)
    mesh.SetNormalsInterpolation(token)
    read = only_mesh(build.read())
    assert read.normals.shape == (count, 3)
    assert read.normals_interpolation == interpolation


def test_primvar_normals_win(build: StageBuilder) -> None:
    mesh = build.quad()
    mesh.CreateNormalsAttr([(0, 0, 1)] * 4)
    primvar = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("normals", Types.Normal3fArray, "constant")
    primvar.Set([(1, 0, 0)])
    np.testing.assert_array_equal(only_mesh(build.read()).normals, [[1, 0, 0]])


def test_indexed_primvar(build: StageBuilder, picture: Path) -> None:
    mesh = build.quad()
    wear_texture(build, mesh, picture)
    st = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("st", Types.TexCoord2fArray, "faceVarying")
    st.Set([(0, 0), (1, 1)])
    st.SetIndices([0, 1, 1, 0])
    read = only_mesh(build.read())
    np.testing.assert_array_equal(read.st, [[0, 0], [1, 1], [1, 1], [0, 0]])
    assert read.st_interpolation == _core.Interpolation.FaceVarying


def test_primvar_index_out_of_range(build: StageBuilder, picture: Path) -> None:
    mesh = build.quad()
    wear_texture(build, mesh, picture)
    st = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("st", Types.TexCoord2fArray, "vertex")
    st.Set([(0, 0), (1, 1)])
    st.SetIndices([0, 1, 2, 0])
    contents = build.read()
    assert only_mesh(contents).st.shape == (0, 2)
    assert "/Quad: primvar 'st' is ignored: an index is out of range" in warning_texts(contents)


@pytest.mark.parametrize("name", ["st", "normals"])
def test_primvar_of_wrong_length(build: StageBuilder, picture: Path, name: str) -> None:
    mesh = build.quad()
    wear_texture(build, mesh, picture)
    types = {"st": Types.TexCoord2fArray, "normals": Types.Normal3fArray}
    primvar = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(name, types[name], "vertex")
    primvar.Set([(0,) * (2 if name == "st" else 3)] * 3)
    contents = build.read()
    assert len(contents.scene.shapes) == 1
    assert not getattr(only_mesh(contents), name).size
    assert f"/Quad: '{name}' is ignored: 3 values" in warning_texts(contents)


def test_primvar_not_finite(build: StageBuilder) -> None:
    build.quad().CreateNormalsAttr([(0, 0, math.nan)] * 4)
    contents = build.read()
    assert not only_mesh(contents).normals.size
    assert "/Quad: the normals are ignored" in warning_texts(contents)


def test_inherited_st(build: StageBuilder, picture: Path) -> None:
    UsdGeom.Xform.Define(build.stage, "/Parent")
    parent = UsdGeom.PrimvarsAPI(build.stage.GetPrimAtPath("/Parent"))
    parent.CreatePrimvar("st", Types.TexCoord2fArray, "constant").Set([(0.25, 0.5)])
    wear_texture(build, build.quad("/Parent/Quad"), picture)
    read = only_mesh(build.read())
    np.testing.assert_array_equal(read.st, [[0.25, 0.5]])
    assert read.st_interpolation == _core.Interpolation.Constant


def test_unneeded_st_is_not_read(build: StageBuilder) -> None:
    """Nothing is said of what is wrong with it, either."""
    st = UsdGeom.PrimvarsAPI(build.quad()).CreatePrimvar("st", Types.TexCoord2fArray, "vertex")
    st.Set([(0, 0)] * 3)
    contents = build.read()
    assert not only_mesh(contents).st.size
    assert contents.warnings == ()


# ---------------------------------------------------------------------------------- holes, subsets


def test_holes_take_their_primvars_along(build: StageBuilder, picture: Path) -> None:
    mesh = build.strip()
    wear_texture(build, mesh, picture)
    mesh.CreateHoleIndicesAttr([1])
    mesh.CreateNormalsAttr([(0, 0, face) for face in range(3)])
    mesh.SetNormalsInterpolation("uniform")
    st = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("st", Types.TexCoord2fArray, "faceVarying")
    st.Set([(corner, 0) for corner in range(12)])
    read = only_mesh(build.read())
    np.testing.assert_array_equal(read.face_vertex_counts, [4, 4])
    np.testing.assert_array_equal(read.face_vertex_indices, [0, 1, 5, 4, 2, 3, 7, 6])
    np.testing.assert_array_equal(read.normals[:, 2], [0, 2])
    np.testing.assert_array_equal(read.st[:, 0], [0, 1, 2, 3, 8, 9, 10, 11])


def test_faces_of_two_corners_are_left_out(build: StageBuilder) -> None:
    mesh = build.quad()
    mesh.GetFaceVertexCountsAttr().Set([2, 4])
    mesh.GetFaceVertexIndicesAttr().Set([0, 1, 0, 1, 2, 3])
    contents = build.read()
    np.testing.assert_array_equal(only_mesh(contents).face_vertex_indices, [0, 1, 2, 3])
    assert "1 faces of fewer than three corners" in warning_texts(contents)


def test_geom_subsets(build: StageBuilder) -> None:
    mesh = build.strip()
    mesh.CreateHoleIndicesAttr([0])
    body = build.material(path="/Body")
    side = build.material(path="/Side")
    build.bind(mesh, body)
    subset = UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).CreateMaterialBindSubset(
        "side", Vt.IntArray([2])
    )
    build.bind(subset, side)
    scene = build.read().scene
    (shape,) = scene.shapes
    assert [scene.materials[index].name for index in shape.materials] == ["/Body", "/Side"]
    (read,) = scene.geometries
    assert isinstance(read, _core.MeshDesc)
    np.testing.assert_array_equal(read.face_materials, [0, 1])


def test_geom_subset_out_of_range(build: StageBuilder) -> None:
    mesh = build.quad()
    api = UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim())
    build.bind(api.CreateMaterialBindSubset("all", Vt.IntArray([0, 7])), build.material())
    contents = build.read()
    np.testing.assert_array_equal(only_mesh(contents).face_materials, [1])
    assert "/Quad/all: face indices out of range" in warning_texts(contents)


# ------------------------------------------------------------------------------------- subdivision


def test_subdivision_becomes_a_smooth_cage(build: StageBuilder) -> None:
    mesh = build.quad()
    mesh.CreateSubdivisionSchemeAttr("catmullClark")
    contents = build.read()
    read = only_mesh(contents)
    np.testing.assert_allclose(read.normals, [[0, 0, 1]] * 4)
    assert read.normals_interpolation == _core.Interpolation.Vertex
    assert "/Quad: subdivisionScheme 'catmullClark' is not supported" in warning_texts(contents)
    assert "smooth normals" in warning_texts(contents)


def test_smooth_normals_of_a_left_handed_cage(build: StageBuilder) -> None:
    build.quad(subdivisionScheme="loop", orientation="leftHanded")
    np.testing.assert_allclose(only_mesh(build.read()).normals, [[0, 0, -1]] * 4)


def test_smooth_normals_meet_at_edges(build: StageBuilder) -> None:
    mesh = build.quad(subdivisionScheme="catmullClark")
    mesh.GetPointsAttr().Set([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (1, 0, -1), (1, 1, -1)])
    mesh.GetFaceVertexCountsAttr().Set([4, 4])
    mesh.GetFaceVertexIndicesAttr().Set([0, 1, 2, 3, 1, 4, 5, 2])
    normals = only_mesh(build.read()).normals
    np.testing.assert_allclose(normals[0], [0, 0, 1], atol=1e-6)
    np.testing.assert_allclose(normals[1], [math.sqrt(0.5), 0, math.sqrt(0.5)], atol=1e-6)
    np.testing.assert_allclose(normals[4], [1, 0, 0], atol=1e-6)


def test_subdivision_keeps_authored_normals(build: StageBuilder) -> None:
    build.quad(subdivisionScheme="catmullClark").CreateNormalsAttr([(0, 1, 0)] * 4)
    contents = build.read()
    np.testing.assert_array_equal(only_mesh(contents).normals, [[0, 1, 0]] * 4)
    assert "with its authored normals" in warning_texts(contents)


def test_subdivision_warns_once(build: StageBuilder) -> None:
    build.quad("/A", subdivisionScheme="catmullClark")
    build.quad("/B", subdivisionScheme="catmullClark")
    (warning,) = build.read().warnings
    assert (warning.path, warning.count) == ("/A", 2)
    assert str(warning).endswith("(and 1 more)")


def test_bilinear_is_a_polygon_mesh(build: StageBuilder) -> None:
    build.quad(subdivisionScheme="bilinear")
    contents = build.read()
    assert not only_mesh(contents).normals.size
    assert contents.warnings == ()


# --------------------------------------------------------------------------------- unusable meshes


@pytest.mark.parametrize(
    ("attributes", "reason"),
    [
        ({"points": []}, "it has no points"),
        ({"faceVertexCounts": []}, "it has no faces"),
        ({"points": [(0, 0, math.nan)] * 4}, "point 0 is not finite"),
        ({"faceVertexIndices": [0, 1, 2, 4]}, "index 4 is out of range for 4 points"),
        ({"faceVertexIndices": [0, 1, 2, -1]}, "index -1 is out of range for 4 points"),
        ({"faceVertexIndices": [0, 1, 2]}, "add up to 4 but there are 3"),
        ({"faceVertexCounts": [-4]}, "negative number of corners"),
        ({"holeIndices": [0]}, "no face is left"),
    ],
)
def test_unusable_mesh_is_skipped(
    build: StageBuilder, attributes: dict[str, Any], reason: str
) -> None:
    build.quad("/Good")
    build.quad("/Bad", **attributes)
    contents = build.read()
    assert [shape.name for shape in contents.scene.shapes] == ["/Good"]
    (warning,) = contents.warnings
    assert warning.path == "/Bad"
    assert f"the mesh is skipped: {reason}" in warning.message or reason in warning.message


def test_every_unusable_mesh_is_named(build: StageBuilder) -> None:
    build.quad("/A", points=[])
    build.quad("/B", points=[])
    assert [warning.path for warning in build.read().warnings] == ["/A", "/B"]


# -------------------------------------------------------------------------- visibility and purpose


def test_invisible_subtree(build: StageBuilder) -> None:
    UsdGeom.Xform.Define(build.stage, "/Parent").CreateVisibilityAttr("invisible")
    build.quad("/Parent/Quad")
    assert build.read().scene.shapes == []


def test_purposes(build: StageBuilder) -> None:
    for purpose in ("default", "render", "proxy", "guide"):
        UsdGeom.Xform.Define(build.stage, f"/{purpose}").CreatePurposeAttr(purpose)
        build.quad(f"/{purpose}/Quad")
    assert [shape.name for shape in build.read().scene.shapes] == ["/default/Quad", "/render/Quad"]


def test_inactive_and_abstract_prims(build: StageBuilder) -> None:
    build.quad("/Off").GetPrim().SetActive(False)
    build.stage.CreateClassPrim("/Class")
    build.quad("/Class/Quad")
    assert build.read().scene.shapes == []


# --------------------------------------------------------------------------------------- implicits


def test_implicits(build: StageBuilder) -> None:
    stage = build.stage
    build.set(UsdGeom.Sphere.Define(stage, "/a").GetPrim(), radius=3.0)
    build.set(UsdGeom.Cube.Define(stage, "/b").GetPrim(), size=4.0)
    build.set(UsdGeom.Cylinder.Define(stage, "/c").GetPrim(), radius=5.0, height=6.0, axis="X")
    build.set(UsdGeom.Cone.Define(stage, "/d").GetPrim(), radius=7.0, height=8.0, axis="Y")
    build.set(UsdGeom.Capsule.Define(stage, "/e").GetPrim(), radius=9.0, height=10.0)
    build.set(UsdGeom.Plane.Define(stage, "/f").GetPrim(), width=11.0, length=12.0, axis="Y")
    sphere, cube, cylinder, cone, capsule, plane = build.read().scene.geometries
    assert isinstance(sphere, _core.SphereDesc)
    assert sphere.radius == 3
    assert isinstance(cube, _core.CubeDesc)
    assert cube.size == 4
    assert isinstance(cylinder, _core.CylinderDesc)
    assert (cylinder.radius, cylinder.height, cylinder.axis) == (5, 6, _core.Axis.X)
    assert isinstance(cone, _core.ConeDesc)
    assert (cone.radius, cone.height, cone.axis) == (7, 8, _core.Axis.Y)
    assert isinstance(capsule, _core.CapsuleDesc)
    assert (capsule.radius, capsule.height, capsule.axis) == (9, 10, _core.Axis.Z)
    assert isinstance(plane, _core.PlaneDesc)
    assert (plane.width, plane.length, plane.axis) == (11, 12, _core.Axis.Y)


def test_schemas_of_two_radii(build: StageBuilder) -> None:
    stage = build.stage
    build.set(UsdGeom.Cylinder_1.Define(stage, "/a").GetPrim(), radiusTop=2.0, radiusBottom=2.0)
    build.set(UsdGeom.Capsule_1.Define(stage, "/b").GetPrim(), radiusTop=1.0, radiusBottom=3.0)
    contents = build.read()
    cylinder, capsule = contents.scene.geometries
    assert isinstance(cylinder, _core.CylinderDesc)
    assert cylinder.radius == 2
    assert isinstance(capsule, _core.CapsuleDesc)
    assert capsule.radius == 2
    (warning,) = contents.warnings
    assert warning.path == "/b"


def test_unsupported_gprims_warn_once_per_type(build: StageBuilder) -> None:
    for path in ("/a", "/b"):
        UsdGeom.BasisCurves.Define(build.stage, path)
    UsdGeom.Points.Define(build.stage, "/c")
    contents = build.read()
    assert contents.scene.shapes == []
    assert [str(warning) for warning in contents.warnings] == [
        "/a: BasisCurves is not supported; skipped (and 1 more)",
        "/c: Points is not supported; skipped",
    ]
