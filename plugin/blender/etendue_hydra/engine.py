"""The render engine."""

from __future__ import annotations

from typing import Any

import bpy

from .plugin_files import register_delegate

# Blender's name of a pass, the AOV that fills it, its channels as Blender wants them.
PASSES = (
    ("use_pass_combined", "Combined", "color", "RGBA", "COLOR"),
    ("use_pass_z", "Depth", "cameraDepth", "Z", "VALUE"),
    ("use_pass_normal", "Normal", "normal", "XYZ", "VECTOR"),
    ("use_pass_diffuse_color", "DiffCol", "albedo", "RGB", "COLOR"),
)


class EtendueRenderEngine(bpy.types.HydraRenderEngine):
    """Final renders and the viewport."""

    bl_idname = "HYDRA_ETENDUE"
    bl_label = "Etendue"
    bl_info = "Bidirectional path tracing with the adjoint corrections"
    bl_use_preview = False
    # With a context of the graphics card Blender hands the delegate no buffers to fill.
    bl_use_gpu_context = False
    bl_use_materialx = True
    bl_delegate_id = "HdEtendueRendererPlugin"

    @classmethod
    def register(cls) -> None:
        """Called by Blender when the class is registered."""
        register_delegate()

    # What is rendered need not be what the window shows, which is all that bpy.context knows.

    def update(self, data: bpy.types.BlendData, depsgraph: bpy.types.Depsgraph) -> None:
        """Called by Blender before a final render."""
        self._depsgraph = depsgraph
        super().update(data, depsgraph)

    def view_update(self, context: bpy.types.Context, depsgraph: bpy.types.Depsgraph) -> None:
        """Called by Blender when something has changed in the viewport."""
        self._depsgraph = depsgraph
        super().view_update(context, depsgraph)

    def get_render_settings(self, engine_type: str) -> dict[str, Any]:
        """What the delegate is told, by the names of its settings. Called by both updates."""
        scene = self._depsgraph.scene_eval
        settings = scene.etendue
        in_viewport = engine_type == "VIEWPORT"
        told: dict[str, Any] = {
            "etendue:integrator": settings.integrator,
            "etendue:samplesPerPixel": settings.viewport_samples
            if in_viewport
            else settings.samples,
            "etendue:timeLimit": 0.0 if in_viewport else settings.time_limit,
            "etendue:errorTarget": 0.0 if in_viewport else settings.error_target,
            "etendue:maxDepth": settings.max_depth,
            "etendue:seed": settings.seed,
            "etendue:threads": scene.render.threads if scene.render.threads_mode == "FIXED" else 0,
            "etendue:adjoint:refraction": settings.adjoint_refraction,
            "etendue:adjoint:shadingNormal": settings.adjoint_shading_normal,
            "etendue:adjoint:phong": settings.adjoint_phong,
        }
        if not in_viewport:
            layer = self._depsgraph.view_layer_eval
            told |= {
                f"aovToken:{name}": aov
                for switch, name, aov, _, _ in PASSES
                if getattr(layer, switch)
            }
        return told

    def update_render_passes(
        self, scene: bpy.types.Scene, render_layer: bpy.types.ViewLayer
    ) -> None:
        """Tells Blender which passes there are."""
        for switch, name, _, channels, kind in PASSES:
            if getattr(render_layer, switch):
                self.register_pass(scene, render_layer, name, len(channels), channels, kind)


register, unregister = bpy.utils.register_classes_factory((EtendueRenderEngine,))
