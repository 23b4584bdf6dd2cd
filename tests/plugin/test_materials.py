"""Materials and textures, through Hydra and through the stage reader."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from pxr import Gf, Sdf, UsdGeom, UsdShade, UsdUtils

import etendue
from support.hdr_file import write_hdr
from support.hydra_host import HydraHost
from support.hydra_studio import (
    ENVIRONMENTS,
    SKY,
    Studio,
    assert_parity,
    exported,
    recorded,
    reference,
)
from support.same_picture import assert_same_picture

Types = Sdf.ValueTypeNames


@ENVIRONMENTS
@pytest.mark.parametrize("context", ["", "mtlx"])
def test_a_texture_with_coordinates_of_another_name(
    host: HydraHost, tmp_path: Path, environment: dict[str, str], context: str
) -> None:
    studio = Studio()
    mesh = studio.box("/Box")
    coordinates = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(
        "map2", Types.TexCoord2fArray, "faceVarying"
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
        **{"in": reader.CreateOutput("result", Types.Float2)},
    )
    image = studio.node(
        "UsdUVTexture",
        "/Image",
        file=SKY,
        wrapS="repeat",
        wrapT="mirror",
        scale=Gf.Vec4f(0.5, 0.5, 0.5, 1),
        st=place.CreateOutput("result", Types.Float2),
    )
    return studio.material(diffuseColor=image.CreateOutput("rgb", Types.Float3))


def mtlx_textured(studio: Studio) -> UsdShade.Material:
    """OpenPBR with MaterialX's nodes."""
    reader = studio.node("ND_geompropvalue_vector2", "/Coordinates", geomprop="map2")
    image = studio.node(
        "ND_image_color3",
        "/Image",
        file=SKY,
        texcoord=reader.CreateOutput("out", Types.Float2),
    )
    return studio.material(
        "ND_open_pbr_surface_surfaceshader",
        context="mtlx",
        base_color=image.CreateOutput("out", Types.Color3f),
        specular_roughness=0.4,
    )


def floor_with_coordinates(studio: Studio, name: str, size: float) -> UsdGeom.Mesh:
    """The studio's floor, with texture coordinates from 0 to `size`."""
    floor = UsdGeom.Mesh.Get(studio.stage, "/Floor")
    coordinates = UsdGeom.PrimvarsAPI(floor).CreatePrimvar(name, Types.TexCoord2fArray, "vertex")
    coordinates.Set([(0, 0), (size, 0), (size, size), (0, size)])
    return floor


def painted(studio: Studio, path: str, file: str, name: str = "st") -> UsdShade.Material:
    """Diffuse, of a texture."""
    reader = studio.node("UsdPrimvarReader_float2", f"{path}/Coordinates", varname=name)
    image = studio.node(
        "UsdUVTexture",
        f"{path}/Image",
        file=Sdf.AssetPath(file),
        fallback=Gf.Vec4f(0.7, 0.2, 0.1, 1),
        st=reader.CreateOutput("result", Types.Float2),
    )
    return studio.material(path=path, diffuseColor=image.CreateOutput("rgb", Types.Float3))


def paint(file: Path, seed: int) -> None:
    """A texture of a few random colours."""
    write_hdr(file, np.random.default_rng(seed).uniform(0.1, 0.9, (4, 4, 3)))


@ENVIRONMENTS
@pytest.mark.parametrize("tiles", [(1001, 1002, 1011, 1012), (1001, 1012)])
def test_sets_of_tiles(
    host: HydraHost, tmp_path: Path, environment: dict[str, str], tiles: tuple[int, ...]
) -> None:
    for tile in tiles:
        paint(tmp_path / f"tile.{tile}.hdr", tile)
    studio = Studio()
    floor = floor_with_coordinates(studio, "st", 2)
    studio.bind(floor, painted(studio, "/Tiles", "./tile.<UDIM>.hdr"))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
@pytest.mark.parametrize("file", ["./tile.<UDIM>.hdr", "./missing.hdr"])
def test_missing_textures(
    host: HydraHost, tmp_path: Path, environment: dict[str, str], file: str
) -> None:
    studio = Studio()
    studio.bind(floor_with_coordinates(studio, "st", 2), painted(studio, "/Paint", file))
    with pytest.warns(etendue.EtendueWarning, match="is not found; the texture's fallback"):
        said = assert_parity(host, studio, tmp_path, environment)
    assert "</Paint/Image>: texture file" in said
    assert "is not found; the texture's fallback colour is used" in said


@ENVIRONMENTS
def test_textures_in_a_package(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    paint(tmp_path / "paint.hdr", 1)
    studio = Studio()
    studio.bind(floor_with_coordinates(studio, "st", 1), painted(studio, "/Paint", "./paint.hdr"))
    package = tmp_path / "stage.usdz"
    UsdUtils.CreateNewUsdzPackage(str(exported(studio, tmp_path)), str(package))
    (tmp_path / "paint.hdr").unlink()
    ours, _ = recorded(host, package, environment)
    assert_same_picture(ours, reference(package, ours))


@ENVIRONMENTS
def test_subsets_whose_materials_read_different_coordinates(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    for index in range(2):
        paint(tmp_path / f"paint{index}.hdr", index)
    studio = Studio()
    mesh = studio.box("/Box")
    for name, size in (("one", 1.0), ("two", 0.5)):
        coordinates = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(
            name, Types.TexCoord2fArray, "faceVarying"
        )
        corners = [(0, 0), (size, 0), (size, size), (0, size)]
        coordinates.Set(corners * 2)
    studio.bind(mesh, painted(studio, "/One", "./paint0.hdr", "one"))
    subset = UsdShade.MaterialBindingAPI(mesh.GetPrim()).CreateMaterialBindSubset("Side", [1])
    studio.bind(subset, painted(studio, "/Two", "./paint1.hdr", "two"))
    with pytest.warns(etendue.EtendueWarning, match="several texture coordinates; 'one'"):
        said = assert_parity(host, studio, tmp_path, environment)
    assert "</Box>: its materials read several texture coordinates; 'one'" in said


def ring(
    studio: Studio, node: str, outer: str, inner: str, kind: Sdf.ValueTypeName
) -> UsdShade.Output:
    """Two nodes that feed each other; the output of one."""
    nodes = [studio.node(node, f"/Ring/{name}") for name in ("A", "B")]
    outputs = [made.CreateOutput(outer, kind) for made in nodes]
    for made, output in zip(nodes, reversed(outputs), strict=True):
        made.CreateInput(inner, kind).ConnectToSource(output)
    return outputs[0]


def ring_of_places(studio: Studio) -> UsdShade.Material:
    """A texture at coordinates that depend on themselves."""
    place = ring(studio, "UsdTransform2d", "result", "in", Types.Float2)
    image = studio.node("UsdUVTexture", "/Ring/Image", file=SKY, st=place)
    return studio.material(path="/Ring", diffuseColor=image.CreateOutput("rgb", Types.Float3))


def ring_of_constants(studio: Studio) -> UsdShade.Material:
    """A colour that depends on itself."""
    color = ring(studio, "ND_constant_color3", "out", "value", Types.Color3f)
    return studio.material(
        "ND_open_pbr_surface_surfaceshader", "/Ring", context="mtlx", base_color=color
    )


@ENVIRONMENTS
@pytest.mark.parametrize("make", [ring_of_places, ring_of_constants])
def test_rings_of_nodes_are_warned_about(
    host: HydraHost,
    tmp_path: Path,
    environment: dict[str, str],
    make: Callable[[Studio], UsdShade.Material],
) -> None:
    studio = Studio()
    studio.bind(studio.box("/Box"), make(studio))
    picture, said = recorded(host, exported(studio, tmp_path), environment)
    assert picture.mean() > 0
    assert "ring" in said or "cycle" in said
