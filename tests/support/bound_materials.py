"""Quads with a material, and what the reader made of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pxr import Sdf, UsdShade

from etendue import _core
from etendue.usd_reader import StageContents
from support.stage_builder import StageBuilder, Types

OPEN_PBR = "ND_open_pbr_surface_surfaceshader"


def material(contents: StageContents) -> _core.MaterialDesc:
    """What the only shape is made of."""
    (shape,) = contents.scene.shapes
    return contents.scene.materials[shape.materials[0]]


def preview(contents: StageContents) -> _core.PreviewSurfaceMaterial:
    model = material(contents).model
    assert isinstance(model, _core.PreviewSurfaceMaterial)
    return model


def open_pbr(contents: StageContents) -> _core.OpenPbrMaterial:
    model = material(contents).model
    assert isinstance(model, _core.OpenPbrMaterial)
    return model


def bound(build: StageBuilder, node: str = "UsdPreviewSurface", **inputs: Any) -> UsdShade.Shader:
    """A quad with a material; returns the surface node."""
    build.bind(build.quad(), build.material(node, **inputs))
    return UsdShade.Shader(build.stage.GetPrimAtPath("/Material/Surface"))


def textured(
    build: StageBuilder,
    file: Path | str,
    output: str = "rgb",
    name: str = "diffuseColor",
    **inputs: Any,
) -> UsdShade.Shader:
    """bound(), with a texture node on one input."""
    surface = bound(build)
    node = build.node("UsdUVTexture", "/Material/Texture", file=Sdf.AssetPath(str(file)), **inputs)
    surface.CreateInput(name, Types.Color3f).ConnectToSource(
        node.CreateOutput(output, Types.Float3)
    )
    return node
