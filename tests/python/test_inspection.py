"""What a stage is said to hold and to need."""

from __future__ import annotations

from typing import Any

import pytest
from pxr import Sdf, UsdGeom, UsdShade

from etendue.inspection import Inspection, inspect_contents
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
    assert told.memory_bytes > 0


def test_instanced_triangles(build: StageBuilder) -> None:
    schema = UsdGeom.PointInstancer.Define(build.stage, "/I")
    build.quad("/I/p")
    schema.CreatePrototypesRel().SetTargets([Sdf.Path("/I/p")])
    schema.CreateProtoIndicesAttr([0] * 5)
    schema.CreatePositionsAttr([(0, 0, 0)] * 5)
    told = inspect(build)
    assert (told.triangles, told.instances, told.instanced_triangles) == (2, 5, 10)


@pytest.mark.parametrize(
    ("node", "inputs", "needs"),
    [
        ("UsdPreviewSurface", {}, {"rough_reflection"}),
        ("UsdPreviewSurface", {"roughness": 0.0}, {"smooth_reflection"}),
        ("UsdPreviewSurface", {"opacity": 0.5}, {"rough_reflection", "smooth_transmission"}),
        (
            "UsdPreviewSurface",
            {"opacity": 0.5, "opacityMode": "presence"},
            {"rough_reflection", "cutouts"},
        ),
        (OPEN_PBR, {"specular_weight": 0.0}, set()),
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
        (OPEN_PBR, {"coat_weight": 1.0}, {"smooth_reflection", "rough_reflection"}),
        (OPEN_PBR, {"geometry_opacity": 0.5, "specular_weight": 0.0}, {"cutouts"}),
    ],
)
def test_lobes(
    build: StageBuilder, node: str, inputs: dict[str, float | str], needs: set[str]
) -> None:
    requirements = made_of(build, node, **inputs).requirements
    assert {name for name, on in vars(requirements).items() if on} == needs


def test_lights_and_lens(build: StageBuilder) -> None:
    build.camera(fStop=2.0, focusDistance=3.0)
    build.light("DistantLight", "/Sun")
    build.light("SphereLight", "/Point", radius=0.0)
    needs = inspect(build).requirements
    assert needs.infinite_lights
    assert needs.point_lights
    assert needs.thin_lens
    assert not needs.area_lights


def test_textures(build: StageBuilder, tmp_path_factory: pytest.TempPathFactory) -> None:
    file = tmp_path_factory.mktemp("maps") / "a.png"
    file.write_bytes(b"x" * 1000)
    before = inspect(build).memory_bytes
    node = build.node("UsdUVTexture", "/T", file=Sdf.AssetPath(str(file)))
    build.bind(build.quad(), build.material())
    surface = UsdShade.Shader(build.stage.GetPrimAtPath("/Material/Surface"))
    surface.CreateInput("roughness", Sdf.ValueTypeNames.Float).ConnectToSource(
        node.CreateOutput("r", Sdf.ValueTypeNames.Float)
    )
    told = inspect(build)
    assert told.textures == (str(file),)
    assert told.memory_bytes >= before + 1000
    assert told.requirements.smooth_reflection
    assert told.requirements.textures
