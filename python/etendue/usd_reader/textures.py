"""Texture nodes (UsdUVTexture, MaterialX image) to TextureDesc, with their coordinates."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from pxr import Sdf, UsdShade

from etendue import _core
from etendue.usd_reader.context import ReadContext
from etendue.usd_reader.networks import (
    Constant,
    NodeOutput,
    constant_input,
    resolve_input,
    shader_id,
    warn_ring,
)
from etendue.usd_reader.texture_files import file_color_space, texture_file

Rgba = tuple[float, float, float, float]
_Affine = npt.NDArray[np.float64]

_WRAPS = {
    "useMetadata": _core.TextureWrap.UseMetadata,
    "black": _core.TextureWrap.Black,
    "clamp": _core.TextureWrap.Clamp,
    "repeat": _core.TextureWrap.Repeat,
    "mirror": _core.TextureWrap.Mirror,
    # MaterialX
    "constant": _core.TextureWrap.Black,
    "periodic": _core.TextureWrap.Repeat,
}
_COLOR_SPACES = {
    "auto": _core.TextureColorSpace.Auto,
    "raw": _core.TextureColorSpace.Raw,
    "sRGB": _core.TextureColorSpace.Srgb,
}

_TRANSFORMS = ("UsdTransform2d", "ND_UsdTransform2d")

DEFAULT_ST = "st"


def is_usd_texture(node_id: str) -> bool:
    """UsdUVTexture, by its USD or its MaterialX name."""
    return node_id == "UsdUVTexture" or node_id.startswith("ND_UsdUVTexture")


def is_image(node_id: str) -> bool:
    """MaterialX image or tiledimage."""
    return node_id.startswith(("ND_image_", "ND_tiledimage_"))


@dataclass(frozen=True)
class TextureRead:
    """A texture of the scene, or (index < 0) the colour that stands in for a missing file."""

    index: int
    fallback: Rgba
    st: str


class TextureReader:
    """Fills SceneDescription.textures, once per node and use."""

    def __init__(self, context: ReadContext) -> None:
        self._context = context
        self._textures: dict[tuple[str, bool, float, bool], TextureRead] = {}

    def read(
        self,
        node: NodeOutput,
        *,
        data: bool = False,
        multiplier: float = 1.0,
        unpack_normal: bool = False,
    ) -> TextureRead:
        """The texture of a node for which is_usd_texture or is_image holds.

        `data`: never decoded from sRGB. `multiplier` scales its colour. `unpack_normal` maps
        [0, 1] to [-1, 1] (MaterialX normalmap).
        """
        key = (str(node.shader.GetPath()), data, multiplier, unpack_normal)
        if key not in self._textures:
            self._textures[key] = self._read(node, data, multiplier, unpack_normal)
        return self._textures[key]

    def _read(
        self, node: NodeOutput, data: bool, multiplier: float, unpack_normal: bool
    ) -> TextureRead:
        shader = node.shader
        desc = _core.TextureDesc(name=str(shader.GetPath()))
        if is_usd_texture(node.node_id):
            st_input = "st"
            self._fill_usd_texture(shader, desc)
        else:
            st_input = "texcoord"
            self._fill_image(shader, desc)
        if data and desc.color_space == _core.TextureColorSpace.Auto:
            desc.color_space = _core.TextureColorSpace.Raw
        scale, bias = np.array(desc.scale), np.array(desc.bias)
        if unpack_normal:
            scale, bias = 2 * scale, 2 * bias - 1
        factor = np.array([multiplier, multiplier, multiplier, 1.0])
        desc.scale, desc.bias = _rgba(scale * factor), _rgba(bias * factor)
        fallback = _rgba(np.array(desc.fallback) * factor)
        desc.fallback = fallback

        st, affine = self._texture_coordinates(shader, st_input)
        if node.node_id.startswith("ND_tiledimage"):
            tiling = constant_input(self._context, shader, "uvtiling", (1.0, 1.0))
            offset = constant_input(self._context, shader, "uvoffset", (0.0, 0.0))
            affine = _affine(np.diag([tiling[0], tiling[1]]), (-offset[0], -offset[1])) @ affine
        desc.st_transform = affine[:2].ravel().tolist()

        file = self._file(shader)
        if file is None:
            return TextureRead(-1, fallback, st)
        desc.file = file
        return TextureRead(self._context.scene.add_texture(desc), fallback, st)

    def _fill_usd_texture(self, shader: UsdShade.Shader, desc: _core.TextureDesc) -> None:
        context = self._context
        unset = "periodic" if shader_id(shader).startswith("ND_") else "useMetadata"
        desc.wrap_s = self._wrap(shader, "wrapS", unset)
        desc.wrap_t = self._wrap(shader, "wrapT", unset)
        desc.scale = _rgba(constant_input(context, shader, "scale", (1, 1, 1, 1)))
        desc.bias = _rgba(constant_input(context, shader, "bias", (0, 0, 0, 0)))
        desc.fallback = _rgba(constant_input(context, shader, "fallback", (0, 0, 0, 1)))
        token = str(constant_input(context, shader, "sourceColorSpace", ""))
        if not token:
            desc.color_space = self._file_color_space(shader)
        elif token in _COLOR_SPACES:
            desc.color_space = _COLOR_SPACES[token]
        else:
            context.report.warn(
                f"sourceColorSpace {token}",
                shader.GetPath(),
                f"unknown sourceColorSpace '{token}'; 'auto' is used",
            )

    def _fill_image(self, shader: UsdShade.Shader, desc: _core.TextureDesc) -> None:
        desc.wrap_s = self._wrap(shader, "uaddressmode", "periodic")
        desc.wrap_t = self._wrap(shader, "vaddressmode", "periodic")
        default = np.atleast_1d(constant_input(self._context, shader, "default", (0.0, 0.0, 0.0)))
        if default.size == 1:
            default = np.repeat(default, 3)
        desc.fallback = _rgba([*default, *(0.0, 0.0, 0.0, 1.0)[default.size :]])
        if "_color" in shader_id(shader):
            desc.color_space = self._file_color_space(shader)
        else:
            desc.color_space = _core.TextureColorSpace.Raw

    def _wrap(self, shader: UsdShade.Shader, name: str, unset: str) -> _core.TextureWrap:
        token = str(constant_input(self._context, shader, name, unset))
        if token not in _WRAPS:
            self._context.report.warn(
                f"wrap {token}", shader.GetPath(), f"unknown {name} '{token}'; '{unset}' is used"
            )
            token = unset
        return _WRAPS[token]

    def _file_color_space(self, shader: UsdShade.Shader) -> _core.TextureColorSpace:
        source = resolve_input(self._context, shader, "file")
        if not isinstance(source, Constant):
            return _core.TextureColorSpace.Auto
        return file_color_space(self._context, shader.GetPath(), source.attribute)

    # ------------------------------------------------------------------------------------ files

    def _file(self, shader: UsdShade.Shader) -> str | None:
        """The resolved file, or None (after a warning) when there is none."""
        source = resolve_input(self._context, shader, "file")
        asset = source.value if isinstance(source, Constant) else None
        if not isinstance(asset, Sdf.AssetPath) or not asset.path:
            self._context.report.warn(
                f"texture without file {shader.GetPath()}",
                shader.GetPath(),
                "the texture names no file; its fallback colour is used",
            )
            return None
        assert isinstance(source, Constant)
        return texture_file(
            self._context,
            shader.GetPath(),
            source.attribute,
            asset,
            "the texture's fallback colour",
        )

    # ------------------------------------------------------------------------------ coordinates

    def _texture_coordinates(self, shader: UsdShade.Shader, name: str) -> tuple[str, _Affine]:
        """The primvar that the texture is read at, and the affine map applied to it, (3, 3)."""
        context = self._context
        affine = np.eye(3)
        seen: set[Sdf.Path] = set()
        source = resolve_input(context, shader, name)
        while isinstance(source, NodeOutput) and source.node_id in _TRANSFORMS:
            path = source.shader.GetPath()
            if path in seen:
                warn_ring(context, path, "of texture coordinates", "primvar 'st' is used")
                return DEFAULT_ST, np.eye(3)
            seen.add(path)
            affine = affine @ self._transform_2d(source.shader)
            source = resolve_input(context, source.shader, "in")
        if isinstance(source, Constant):
            return DEFAULT_ST, affine @ _affine(np.zeros((2, 2)), source.value)
        return DEFAULT_ST if source is None else self._primvar(source), affine

    def _primvar(self, source: NodeOutput) -> str:
        """The name of the primvar that a node reads."""
        node = source.node_id
        if node in ("UsdPrimvarReader_float2", "ND_UsdPrimvarReader_vector2"):
            name = str(constant_input(self._context, source.shader, "varname", DEFAULT_ST))
            return name or DEFAULT_ST
        if node == "ND_geompropvalue_vector2":
            return str(constant_input(self._context, source.shader, "geomprop", DEFAULT_ST))
        if node != "ND_texcoord_vector2":
            self._context.report.warn(
                f"texture coordinate node {node}",
                source.shader.GetPath(),
                f"node '{node}' is not supported for texture coordinates; primvar 'st' is used",
            )
        return DEFAULT_ST

    def _transform_2d(self, shader: UsdShade.Shader) -> _Affine:
        """UsdTransform2d: scale, then rotate counter-clockwise, then translate."""
        angle = math.radians(constant_input(self._context, shader, "rotation", 0.0))
        scale = constant_input(self._context, shader, "scale", (1.0, 1.0))
        translation = constant_input(self._context, shader, "translation", (0.0, 0.0))
        rotation = np.array(
            [[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]]
        )
        return _affine(rotation @ np.diag([scale[0], scale[1]]), translation)


def _affine(linear: _Affine, translation: Sequence[float]) -> _Affine:
    matrix = np.eye(3)
    matrix[:2, :2] = linear
    matrix[:2, 2] = translation[0], translation[1]
    return matrix


def _rgba(values: Sequence[float] | npt.NDArray[np.float64]) -> Rgba:
    red, green, blue, alpha = (float(value) for value in values)
    return red, green, blue, alpha
