"""Inputs of surface shaders as ColorInput and FloatInput."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from pxr import Sdf, UsdShade

from etendue import _core
from etendue.usd_reader.colors import to_rendering_space
from etendue.usd_reader.context import ReadContext
from etendue.usd_reader.networks import (
    Constant,
    NodeOutput,
    constant_input,
    resolve_input,
    shader_id,
    warn_ring,
)
from etendue.usd_reader.textures import TextureReader, is_image, is_usd_texture

_CHANNELS = {"r": 0, "g": 1, "b": 2, "a": 3}
_PRIMVAR_READERS = ("UsdPrimvarReader_", "ND_UsdPrimvarReader_", "ND_geompropvalue_")


class ShaderInputs:
    """The inputs of one surface shader. Reading them collects the texture coordinates they need."""

    def __init__(
        self, context: ReadContext, textures: TextureReader, shader: UsdShade.Shader
    ) -> None:
        self._context = context
        self._textures = textures
        self.shader = shader
        self.st_names: list[str] = []

    def color(
        self, name: str, default: _core.ColorInput, multiplier: float = 1.0
    ) -> _core.ColorInput:
        """A colour in the rendering space; the default when nothing is authored. Both scaled."""
        source = self._resolve(self.shader, name)
        if source is None:
            return _core.ColorInput(value=[channel * multiplier for channel in default.value])
        if isinstance(source, Constant):
            return self._constant_color(name, source, multiplier, default)
        if not self._is_texture(source):
            self._warn_node(source, name)
            return _core.ColorInput(value=[channel * multiplier for channel in default.value])
        if source.output in _CHANNELS:
            self._context.report.warn(
                f"channel as color {shader_id(self.shader)}.{name}",
                self.shader.GetPath(),
                f"input '{name}' is a colour connected to the single channel "
                f"'{source.output}'; the texture's rgb is used",
            )
        read = self._textures.read(source, multiplier=multiplier)
        if read.index < 0:
            return _core.ColorInput(value=read.fallback[:3])
        self._use_st(read.st)
        return _core.ColorInput(texture=read.index)

    def number(self, name: str, default: _core.FloatInput) -> _core.FloatInput:
        """A number; the default when nothing is authored."""
        source = self._resolve(self.shader, name)
        if source is None:
            return default
        if isinstance(source, Constant):
            return _core.FloatInput(value=float(np.ravel(source.value)[0]))
        if not self._is_texture(source):
            self._warn_node(source, name)
            return default
        read = self._textures.read(source)
        channel = _CHANNELS.get(source.output, 0)
        if read.index < 0:
            return _core.FloatInput(value=read.fallback[channel])
        self._use_st(read.st)
        return _core.FloatInput(texture=read.index, channel=channel)

    def constant(self, name: str, default: Any) -> Any:
        """An input that may only be a constant; a connected one is warned about."""
        return constant_input(self._context, self.shader, name, default)

    def normal_texture(self, name: str) -> int:
        """Index of the normal map connected to `name`, else -1."""
        source = self._resolve(self.shader, name)
        if not isinstance(source, NodeOutput):
            return -1
        unpack = source.node_id.startswith("ND_normalmap")
        if unpack:
            inner = self._resolve(source.shader, "in")
            if not isinstance(inner, NodeOutput):
                return -1
            source = inner
        if not self._is_texture(source):
            self._warn_node(source, name)
            return -1
        read = self._textures.read(source, data=True, unpack_normal=unpack)
        if read.index >= 0:
            self._use_st(read.st)
        return read.index

    def is_authored(self, name: str, default: float | Sequence[float]) -> bool:
        """Whether the input is connected to a node or set to something else than `default`."""
        source = self._resolve(self.shader, name)
        if source is None:
            return False
        return isinstance(source, NodeOutput) or not np.allclose(
            np.ravel(np.asarray(source.value, dtype=np.float64)), default
        )

    def _resolve(self, shader: UsdShade.Shader, name: str) -> Constant | NodeOutput | None:
        """resolve_input through the nodes that only pass a constant on."""
        source = resolve_input(self._context, shader, name)
        seen: set[Sdf.Path] = set()
        while isinstance(source, NodeOutput):
            if source.node_id.startswith("ND_constant_"):
                passed_on = "value"
            elif source.node_id.startswith(_PRIMVAR_READERS):
                passed_on = "default" if "geompropvalue" in source.node_id else "fallback"
                self._warn_primvar(source, name)
            else:
                return source
            path = source.shader.GetPath()
            if path in seen:
                warn_ring(self._context, path, f"of input '{name}'", "its default is used")
                return None
            seen.add(path)
            source = resolve_input(self._context, source.shader, passed_on)
        return source

    def _warn_primvar(self, source: NodeOutput, name: str) -> None:
        self._context.report.warn(
            f"primvar reader {shader_id(self.shader)}.{name}",
            source.shader.GetPath(),
            f"input '{name}' reads a primvar, which is supported for texture coordinates only; "
            "the reader's fallback is used",
        )

    def _constant_color(
        self, name: str, source: Constant, multiplier: float, default: _core.ColorInput
    ) -> _core.ColorInput:
        values = np.ravel(np.asarray(source.value, dtype=np.float64))
        if values.size not in (1, 3, 4):
            self._context.report.warn(
                f"not a color {self.shader.GetPath()}.{name}",
                self.shader.GetPath(),
                f"input '{name}' is not a colour; its default is used",
            )
            return default
        rgb = values[:3] if values.size >= 3 else np.repeat(values, 3)
        linear = to_rendering_space(self._context, source.attribute, rgb)
        return _core.ColorInput(value=[channel * multiplier for channel in linear])

    @staticmethod
    def _is_texture(source: NodeOutput) -> bool:
        return is_usd_texture(source.node_id) or is_image(source.node_id)

    def _use_st(self, name: str) -> None:
        if name not in self.st_names:
            self.st_names.append(name)

    def _warn_node(self, source: NodeOutput, name: str) -> None:
        node = source.node_id or "without an id"
        self._context.report.warn(
            f"node {node}",
            source.shader.GetPath(),
            f"node '{node}' is not supported; input '{name}' keeps its default",
        )
