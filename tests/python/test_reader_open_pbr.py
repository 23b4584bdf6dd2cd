"""OpenPBR and the other nodes that are not UsdPreviewSurface."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from pxr import Sdf, UsdShade

from etendue import _core
from support.bound_materials import OPEN_PBR, bound, material, open_pbr, preview
from support.stage_builder import StageBuilder, Types, warning_texts


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
