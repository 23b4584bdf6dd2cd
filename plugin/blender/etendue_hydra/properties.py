"""Settings of the scene."""

from __future__ import annotations

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty

_WRONG = "Switching this off is wrong on purpose: for validation only"


class EtendueSettings(bpy.types.PropertyGroup):
    """Scene.etendue."""

    integrator: EnumProperty(  # type: ignore[valid-type]
        name="Integrator",
        description="How light is found",
        items=(
            ("bdpt", "Bidirectional", "Paths from the camera and from the lights, joined"),
            ("path", "Path", "Paths from the camera; the reference"),
            ("light", "Light", "Paths from the lights, joined to the lens"),
            ("auto", "Automatic", "Path or bidirectional, by a short trial in long renders"),
        ),
        default="bdpt",
    )
    samples: IntProperty(  # type: ignore[valid-type]
        name="Samples", description="Samples per pixel of a final render", default=64, min=1
    )
    viewport_samples: IntProperty(  # type: ignore[valid-type]
        name="Viewport Samples", description="Samples per pixel", default=32, min=1
    )
    time_limit: FloatProperty(  # type: ignore[valid-type]
        name="Time Limit",
        description="Ends a final render after this time; 0: never",
        default=0.0,
        min=0.0,
        subtype="TIME_ABSOLUTE",
        unit="TIME_ABSOLUTE",
    )
    error_target: FloatProperty(  # type: ignore[valid-type]
        name="Error Target",
        description="Ends a final render when its relative error is this small; 0: never",
        default=0.0,
        min=0.0,
        precision=3,
    )
    max_depth: IntProperty(  # type: ignore[valid-type]
        name="Max Bounces", description="0 shows emission only", default=16, min=0
    )
    seed: IntProperty(  # type: ignore[valid-type]
        name="Seed", description="The same seed gives the same picture", default=0, min=0
    )
    adjoint_refraction: BoolProperty(  # type: ignore[valid-type]
        name="Refraction", description=_WRONG, default=True
    )
    adjoint_shading_normal: BoolProperty(  # type: ignore[valid-type]
        name="Shading Normals", description=_WRONG, default=True
    )
    adjoint_phong: BoolProperty(  # type: ignore[valid-type]
        name="Classic Phong", description=_WRONG, default=True
    )

    @classmethod
    def register(cls) -> None:
        """Called by Blender when the class is registered."""
        bpy.types.Scene.etendue = PointerProperty(name="Etendue", type=cls)

    @classmethod
    def unregister(cls) -> None:
        """Called by Blender when the class is taken out."""
        del bpy.types.Scene.etendue


register, unregister = bpy.utils.register_classes_factory((EtendueSettings,))
