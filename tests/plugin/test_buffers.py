"""Render buffers in every format that hosts ask for."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
from pxr import UsdLux

from support.hydra_host import HydraHost, skip_without_library
from support.hydra_studio import SAMPLES, Studio, exported, reference
from support.same_picture import Picture, assert_same_picture

SIZE = (48, 32)
# What a format is made of, how many of it, and the code of 1 where there are codes: as in
# host/buffers.cpp.
FORMATS: dict[str, tuple[npt.DTypeLike, int, int]] = {
    "UNorm8": (np.uint8, 1, 255),
    "UNorm8Vec3": (np.uint8, 3, 255),
    "UNorm8Vec4": (np.uint8, 4, 255),
    "SNorm8Vec4": (np.int8, 4, 127),
    "Float16": (np.float16, 1, 0),
    "Float16Vec3": (np.float16, 3, 0),
    "Float16Vec4": (np.float16, 4, 0),
    "Float32": (np.float32, 1, 0),
    "Float32Vec2": (np.float32, 2, 0),
    "Float32Vec3": (np.float32, 3, 0),
    "Float32Vec4": (np.float32, 4, 0),
    "Int32": (np.int32, 1, 1),
}


def read(folder: Path, name: str) -> Picture:
    """Values (h, w, components), codes as they are; row 0 on top."""
    kind, components, _ = FORMATS[name]
    values = np.fromfile(folder / f"{name}.raw", dtype=kind)
    pixels = values.reshape(SIZE[1], SIZE[0], components)[::-1]
    return np.asarray(pixels, dtype=np.float64)


def in_format(color: Picture, name: str) -> Picture:
    """What a buffer of that format holds for rgba of single precision."""
    kind, components, one = FORMATS[name]
    kept = color[..., :components]
    if not one:
        return np.asarray(kept.astype(kind), dtype=np.float64)
    limits = np.iinfo(np.dtype(kind))
    return np.clip(np.floor(kept * one + 0.5), limits.min, limits.max)


@pytest.fixture(scope="module")
def folder(host: HydraHost, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The stage and its buffers."""
    skip_without_library()
    made = tmp_path_factory.mktemp("buffers")
    studio = Studio()
    studio.box("/Box")
    UsdLux.RectLight.Get(studio.stage, "/Lamp").CreateIntensityAttr(800)
    environment = {"HDETENDUE_SAMPLES_PER_PIXEL": str(SAMPLES)}
    arguments = (exported(studio, made), "/Camera", *SIZE, made)
    host.run("buffers", *arguments, environment=environment)
    return made


def test_colour_of_single_precision(folder: Path) -> None:
    color = read(folder, "Float32Vec4")[..., :3]
    assert_same_picture(color, reference(folder / "stage.usda", color))


@pytest.mark.parametrize("name", FORMATS)
def test_colour_in_other_formats(folder: Path, name: str) -> None:
    color = read(folder, "Float32Vec4")
    assert color.max() > 1  # more than codes hold
    np.testing.assert_array_equal(read(folder, name), in_format(color, name))
