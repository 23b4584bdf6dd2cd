"""What a render returns."""

from __future__ import annotations

import os

import numpy as np
import numpy.typing as npt

from etendue import _core
from etendue.settings import AOVS

FloatArray = npt.NDArray[np.float32]


class Image:
    """AOVs as arrays, scene-linear Rec.709, row 0 on top, and the way into files.

    image["color"] is a float32 array (h, w, 3); AOVs of one channel are (h, w). Every array owns
    its memory: changing it changes neither the image nor what save() writes.
    """

    def __init__(self, rendered: _core.RenderedImage, metadata: dict[str, str]) -> None:
        self._rendered = rendered
        self.metadata = metadata
        """Goes to the header of EXR files."""

    def __getitem__(self, aov: str) -> FloatArray:
        """A new array. KeyError, listing what there is, when the AOV was not rendered."""
        if aov in self.aovs:
            return self._rendered.array(AOVS[aov])
        if aov in self.strategy_images:
            return self._rendered.strategy_array(aov)
        known = ", ".join((*self.aovs, *self.strategy_images))
        raise KeyError(f"no AOV '{aov}' in this image; there are: {known}")

    def __contains__(self, aov: object) -> bool:
        return aov in self.aovs or aov in self.strategy_images

    def __repr__(self) -> str:
        return f"<etendue.Image {self.width}x{self.height}: {', '.join(self.aovs)}>"

    @property
    def aovs(self) -> tuple[str, ...]:
        """Names of what was rendered."""
        return tuple(_core.aov_name(aov) for aov in self._rendered.aovs)

    @property
    def strategy_images(self) -> tuple[str, ...]:
        """Names of the images of single strategies: "st.weighted.s2t3", "st.unweighted.s2t3"."""
        return tuple(self._rendered.strategy_images)

    @property
    def color(self) -> FloatArray:
        """The picture, (h, w, 3), scene-linear Rec.709."""
        return self["color"]

    @property
    def width(self) -> int:
        """Of the window, in pixels."""
        return self._rendered.width

    @property
    def height(self) -> int:
        """Of the window, in pixels."""
        return self._rendered.height

    @property
    def window(self) -> tuple[int, int, int, int]:
        """(x0, y0, x1, y1) within the full image."""
        window = self._rendered.window
        return window.x0, window.y0, window.x1, window.y1

    @property
    def full_size(self) -> tuple[int, int]:
        """(width, height) of the image that the window is part of."""
        return self._rendered.full_width, self._rendered.full_height

    @property
    def statistics(self) -> _core.RenderStatistics:
        """Passes, seconds, error, paths, rays and refused contributions."""
        return self._rendered.statistics

    def for_display(self, display: str = "", view: str = "", ocio: str = "") -> FloatArray:
        """The colour through an OpenColorIO display and view, (h, w, 3), 0..1 for most displays.

        `ocio` names a configuration file; default: $OCIO, else Etendue's own. Raises FileError
        and SettingsError.
        """
        return _core.ColorConfig(ocio).apply(self.color, display, view)

    def save(
        self,
        file: str | os.PathLike[str],
        *,
        display: str = "",
        view: str = "",
        ocio: str = "",
        bits: int = 8,
    ) -> None:
        """Writes .exr (all AOVs, scene-linear) or .png, .tif, .jpg (colour for a display).

        The other arguments concern display images only: see for_display(); `bits` is 8 or 16.
        Raises FileError when the file cannot be written, SettingsError for an unknown extension,
        display or view.
        """
        name = os.fspath(file)
        if _core.image_file_kind(name) == _core.ImageFileKind.SceneLinear:
            _core.write_exr(name, self._rendered, self.metadata)
        else:
            config = _core.ColorConfig(ocio)
            _core.write_display_image(name, self._rendered, config, display, view, bits)
