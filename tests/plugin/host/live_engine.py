"""An imaging engine as interactive hosts drive it: again and again, without a graphics card."""

from __future__ import annotations

import time
from pathlib import Path

from pxr import CameraUtil, Gf, Usd, UsdImagingGL

from plugin.host.names import RENDERER


class LiveEngine:
    """One stage seen through one camera."""

    def __init__(
        self,
        stage: Usd.Stage,
        camera: str,
        size: tuple[int, int],
        crop: tuple[int, int, int, int] | None = None,
    ) -> None:
        """`crop`: x, y, width, height of the data window, row 0 on top."""
        parameters = UsdImagingGL.Engine.Parameters()
        parameters.gpuEnabled = False
        parameters.rendererPluginId = RENDERER
        self._stage = stage
        self.engine = UsdImagingGL.Engine(parameters)
        self.engine.SetRendererAov("color")
        self.engine.SetCameraPath(camera)
        self.engine.SetRenderBufferSize(Gf.Vec2i(*size))
        display = Gf.Range2f(Gf.Vec2f(0, 0), Gf.Vec2f(*size))
        x, y, width, height = crop or (0, 0, *size)
        data = Gf.Rect2i(Gf.Vec2i(x, y), width, height)
        self.engine.SetFraming(CameraUtil.Framing(display, data, 1.0))
        self._parameters = UsdImagingGL.RenderParams()
        self._parameters.enableSceneMaterials = True
        self._parameters.showRender = True

    def set(self, **settings: object) -> None:
        """Settings of the delegate, without their prefix."""
        for name, value in settings.items():
            self.engine.SetRendererSetting(f"etendue:{name}", value)

    def step(self) -> bool:
        """Takes over edits, and what has been rendered; whether the picture is finished."""
        self.engine.Render(self._stage.GetPseudoRoot(), self._parameters)
        return bool(self.engine.IsConverged())

    def finish(self, limit: float = 300.0) -> None:
        """Until the picture is finished. Raises TimeoutError after `limit` seconds."""
        end = time.monotonic() + limit
        while not self.step():
            if time.monotonic() > end:
                raise TimeoutError("the picture is not finished")

    def picture(self, output: Path) -> None:
        """Renders to the end and writes all AOVs, an .exr."""
        self.set(output=str(output))
        self.finish()
        self.set(output="")

    @property
    def stats(self) -> dict[str, object]:
        """What the delegate tells of its render."""
        return dict(self.engine.GetRenderStats())
