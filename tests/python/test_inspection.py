"""What a stage is said to hold and to need."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pxr import Sdf, UsdGeom, UsdShade

import etendue
from etendue.inspection import Inspection, inspect_contents
from support.bound_materials import textured
from support.hdr_file import write_hdr
from support.stage_builder import StageBuilder

OPEN_PBR = "ND_open_pbr_surface_surfaceshader"


def inspect(build: StageBuilder) -> Inspection:
    return inspect_contents(build.read())


def made_of(build: StageBuilder, node: str, **inputs: Any) -> Inspection:
    build.bind(build.quad(), build.material(node, **inputs))
    return inspect(build)


def test_counts(build: StageBuilder) -> None:
    build.lit_quad().strip()
    UsdGeom.Sphere.Define(build.stage, "/Ball")
    told = inspect(build)
    assert told.prims == {"Camera": 1, "Mesh": 2, "Sphere": 1, "SphereLight": 1}
    assert told.geometries == {"Mesh": 2, "Sphere": 1}
    assert told.triangles == 8
    assert told.instances == 0
    assert told.materials == {"Diffuse": 1}


def test_instanced_triangles(build: StageBuilder) -> None:
    schema = UsdGeom.PointInstancer.Define(build.stage, "/I")
    build.quad("/I/p")
    schema.CreatePrototypesRel().SetTargets([Sdf.Path("/I/p")])
    schema.CreateProtoIndicesAttr([0] * 5)
    schema.CreatePositionsAttr([(0, 0, 0)] * 5)
    told = inspect(build)
    assert (told.triangles, told.instances, told.instanced_triangles) == (2, 5, 10)


@pytest.mark.parametrize(
    ("node", "inputs", "lobes"),
    [
        ("UsdPreviewSurface", {}, {"diffuse", "rough_reflection"}),
        ("UsdPreviewSurface", {"roughness": 0.0}, {"diffuse", "smooth_reflection"}),
        ("UsdPreviewSurface", {"metallic": 1.0}, {"rough_reflection"}),
        ("UsdPreviewSurface", {"ior": 1.0}, {"diffuse"}),
        (
            "UsdPreviewSurface",
            {"opacity": 0.5},
            {"diffuse", "rough_reflection", "smooth_transmission"},
        ),
        (
            "UsdPreviewSurface",
            {"opacity": 0.5, "opacityMode": "presence"},
            {"diffuse", "rough_reflection", "cutout"},
        ),
        (OPEN_PBR, {"specular_weight": 0.0}, {"diffuse"}),
        (
            OPEN_PBR,
            {"specular_roughness": 0.0, "transmission_weight": 1.0},
            {"smooth_reflection", "smooth_transmission"},
        ),
        (
            OPEN_PBR,
            {"transmission_weight": 1.0},
            {"rough_reflection", "rough_transmission"},
        ),
        (OPEN_PBR, {"coat_weight": 1.0}, {"diffuse", "smooth_reflection", "rough_reflection"}),
        (OPEN_PBR, {"geometry_opacity": 0.5, "specular_weight": 0.0}, {"diffuse", "cutout"}),
    ],
)
def test_lobes(
    build: StageBuilder, node: str, inputs: dict[str, float | str], lobes: set[str]
) -> None:
    assert set(made_of(build, node, **inputs).requirements.lobes) == lobes


def test_lights_and_lens(build: StageBuilder) -> None:
    build.camera(fStop=2.0, focusDistance=3.0)
    build.light("DistantLight", "/Sun")
    build.light("SphereLight", "/Point", radius=0.0)
    build.light("RectLight", "/Off", intensity=0.0)
    needs = inspect(build).requirements
    assert needs.lights == ("points", "suns")
    assert "thin_lens" in needs.machinery
    assert needs.lobes == ()


def test_textures(build: StageBuilder, tmp_path: Path) -> None:
    file = tmp_path / "a.hdr"
    write_hdr(file, np.full((4, 8, 3), 0.5))
    build.lit_quad()
    textured(build, file, "r", "roughness")
    told = inspect(build)
    assert told.textures == (str(file),)
    assert told.requirements.textures == {str(file): "r"}
    assert {"smooth_reflection", "rough_reflection"} < set(told.requirements.lobes)
    assert told.requirements.attributes == ("st",)
    assert told.memory is not None
    assert told.memory.textures_limit == 1024 * 2**20
    UsdShade.MaterialBindingAPI(build.stage.GetPrimAtPath("/Quad")).UnbindAllBindings()
    bare = inspect(build)
    assert bare.requirements.textures == {}
    assert bare.requirements.attributes == ()
    assert bare.memory is not None
    assert bare.memory.textures_limit == 0


def test_memory(build: StageBuilder) -> None:
    """Of 960 x 540 pixels, with color and alpha: 24 bytes for what is gathered, 24 for splats, 4 to
    count, 64 for first surfaces."""
    told = inspect(build.lit_quad())
    assert told.memory is not None
    assert told.memory.source == 4 * 12 + 4 + 4 * 4
    assert told.memory.vertices == 5 * 12 + 2 * 12
    width, height = etendue.open(build.stage).view()[1]
    assert told.memory.film == width * height * (24 + 24 + 4 + 64)
    assert 0 < told.memory.acceleration < 1e6


def test_memory_that_cannot_be_known(build: StageBuilder) -> None:
    build.quad()
    told = inspect(build)
    assert told.memory is None
    assert told.memory_unknown is not None
    assert "no camera" in told.memory_unknown
    assert told.requirements.lobes == ("diffuse",)
