"""Panels in the properties editor."""

from __future__ import annotations

from collections.abc import Iterator

import bpy

from .engine import EtendueRenderEngine

_ENGINE = EtendueRenderEngine.bl_idname

# Blender's own panels that mean nothing here.
_FOREIGN = frozenset(
    {
        "RENDER_PT_simplify_grease_pencil",
        "RENDER_PT_stamp",
        "DATA_PT_shading",
        "WORLD_PT_viewport_display",
    }
)


class _Panel(bpy.types.Panel):
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"
    COMPAT_ENGINES = {_ENGINE}  # noqa: RUF012 - Blender reads a plain set

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Whether Blender shows the panel."""
        return bool(context.engine in cls.COMPAT_ENGINES)


class RENDER_PT_etendue_sampling(_Panel):  # noqa: N801 - Blender's rule for names
    """Samples and what ends a render."""

    bl_label = "Sampling"

    def draw(self, context: bpy.types.Context) -> None:
        """Fills the panel."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        settings = context.scene.etendue
        for name in ("samples", "viewport_samples", "time_limit", "error_target", "seed"):
            layout.prop(settings, name)


class RENDER_PT_etendue_light_transport(_Panel):  # noqa: N801
    """The integrator."""

    bl_label = "Light Transport"

    def draw(self, context: bpy.types.Context) -> None:
        """Fills the panel."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for name in ("integrator", "max_depth"):
            layout.prop(context.scene.etendue, name)


class RENDER_PT_etendue_adjoint(_Panel):  # noqa: N801
    """The switches of the adjoint corrections."""

    bl_label = "Adjoint Corrections"
    bl_parent_id = "RENDER_PT_etendue_light_transport"
    bl_options = {"DEFAULT_CLOSED"}  # noqa: RUF012 - Blender reads a plain set

    def draw(self, context: bpy.types.Context) -> None:
        """Fills the panel."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.label(text="Off is wrong on purpose", icon="ERROR")
        for name in ("adjoint_refraction", "adjoint_shading_normal", "adjoint_phong"):
            layout.prop(context.scene.etendue, name)


def _shared_panels() -> Iterator[type[bpy.types.Panel]]:
    """Blender's own panels for every engine: output, film format, camera, lights, materials."""
    for panel in bpy.types.Panel.__subclasses__():
        engines = getattr(panel, "COMPAT_ENGINES", ())
        if "BLENDER_RENDER" in engines and panel.__name__ not in _FOREIGN:
            yield panel


_register_classes, _unregister_classes = bpy.utils.register_classes_factory(
    (RENDER_PT_etendue_sampling, RENDER_PT_etendue_light_transport, RENDER_PT_etendue_adjoint)
)


def register() -> None:
    """Adds our panels, and us to Blender's."""
    _register_classes()
    for panel in _shared_panels():
        panel.COMPAT_ENGINES.add(_ENGINE)


def unregister() -> None:
    """Takes them out again."""
    for panel in _shared_panels():
        panel.COMPAT_ENGINES.discard(_ENGINE)
    _unregister_classes()
