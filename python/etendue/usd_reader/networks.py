"""Shader networks: what an input is, a constant or the output of another node."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pxr import Sdf, Usd, UsdShade

from etendue.usd_reader.context import ReadContext


@dataclass(frozen=True)
class Constant:
    """A value authored on the input, or on the interface input that it is connected to."""

    attribute: Usd.Attribute
    value: Any


@dataclass(frozen=True)
class NodeOutput:
    """The output of a node, looked up through node graphs and material interfaces."""

    shader: UsdShade.Shader
    output: str

    @property
    def node_id(self) -> str:
        """The node's identifier, empty when it has none."""
        return shader_id(self.shader)


def shader_id(shader: UsdShade.Shader) -> str:
    """info:id of a shader, empty when it has none."""
    return str(shader.GetShaderId() or "")


def resolve_input(
    context: ReadContext, shader: UsdShade.Shader, name: str
) -> Constant | NodeOutput | None:
    """What feeds the input; None when nothing is authored."""
    shader_input = shader.GetInput(name)
    if not shader_input:
        return None
    attributes = UsdShade.Utils.GetValueProducingAttributes(shader_input)
    own = shader_input.GetAttr()
    if own.HasAuthoredConnections() and (not attributes or attributes[0] == own):
        context.report.warn(
            f"broken connection {own.GetPath()}",
            own.GetPath(),
            "the connection leads nowhere; the input's own value, or its default, is used",
        )
    if not attributes:
        return None
    attribute = attributes[0]
    if UsdShade.Output.IsOutput(attribute):
        return NodeOutput(
            UsdShade.Shader(attribute.GetPrim()), UsdShade.Output(attribute).GetBaseName()
        )
    value = attribute.Get(context.time)
    return None if value is None else Constant(attribute, value)


def constant_input(context: ReadContext, shader: UsdShade.Shader, name: str, default: Any) -> Any:
    """The input as a constant. A connection to a node is warned about; the default stands in."""
    source = resolve_input(context, shader, name)
    if source is None:
        return default
    if isinstance(source, Constant):
        return source.value
    context.report.warn(
        f"connected {shader_id(shader)}.{name}",
        shader.GetPath(),
        f"input '{name}' may only be a constant here; {default} is used",
    )
    return default


def warn_ring(context: ReadContext, node: Sdf.Path, what: str, instead: str) -> None:
    """Nodes that are fed by themselves: nothing can be said of what they give."""
    context.report.warn(
        f"ring of nodes {node}",
        node,
        f"the nodes {what} feed each other in a ring; {instead}",
    )
