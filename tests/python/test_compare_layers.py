"""Which channels of an EXR file etendue.compare looks at: files as renderers write them."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import numpy.typing as npt
import OpenEXR
import pytest

import etendue
from support.compared_pictures import HEIGHT, WIDTH, noisy, scene
from support.exr_file import write_channels, write_color, write_parts

FloatPlane = npt.NDArray[np.float32]


@pytest.fixture
def good(tmp_path: Path) -> Path:
    return write_color(tmp_path / "a.exr", scene())


def rgb(factor: float = 1.0, prefix: str = "") -> dict[str, FloatPlane]:
    """The scene, so many times as bright."""
    return {
        f"{prefix}{name}": np.ascontiguousarray(factor * scene()[..., index], np.float32)
        for index, name in enumerate("RGB")
    }


def other() -> dict[str, FloatPlane]:
    return {"Z": np.ones((HEIGHT, WIDTH), np.float32)}


@pytest.mark.parametrize(
    ("channels", "layer"),
    [
        (rgb(2) | {"A": other()["Z"]}, ""),
        (rgb(2) | rgb(3, "beauty.") | rgb(3, "diffuse."), ""),
        (rgb(2, "C."), "C"),
        (rgb(2, "anything."), "anything"),
        (rgb(2, "ViewLayer.Combined.") | rgb(3, "ViewLayer.DiffCol."), "ViewLayer.Combined"),
        (rgb(2, "Beauty.") | rgb(3, "diffuse.") | other(), "Beauty"),
        (rgb(2, "color.") | rgb(3, "variance."), "color"),
        (rgb(2, "anything.") | rgb(3, "anything.variance."), "anything"),
    ],
)
def test_layers(good: Path, tmp_path: Path, channels: dict[str, FloatPlane], layer: str) -> None:
    found = etendue.compare(good, write_channels(tmp_path / "b.exr", channels))
    assert found.b.layer == layer
    assert found.whole.value == pytest.approx(2)


@pytest.mark.parametrize(
    ("parts", "layer"),
    [
        ({"depth": other(), "picture": rgb(2)}, "picture"),
        ({"variance": rgb(3), "rgba": rgb(2)}, "rgba"),
        ({"diffuse": rgb(3, "diffuse."), "beauty": rgb(2, "beauty.")}, "beauty"),
        ({"left": rgb(3, "diffuse."), "right": rgb(2, "beauty.")}, "right.beauty"),
    ],
)
def test_parts(
    good: Path, tmp_path: Path, parts: dict[str, dict[str, FloatPlane]], layer: str
) -> None:
    found = etendue.compare(good, write_parts(tmp_path / "b.exr", parts))
    assert found.b.layer == layer
    assert found.whole.value == pytest.approx(2)


def test_chosen_layer(tmp_path: Path) -> None:
    channels = rgb() | rgb(2, "diffuse.") | rgb(3, "glossy.")
    a = write_channels(tmp_path / "a.exr", rgb(1, "diffuse."))
    b = write_channels(tmp_path / "b.exr", channels)
    assert etendue.compare(a, b, layer="diffuse").whole.value == pytest.approx(2)
    listed = "has no layer 'Diffuse' with R, G, B; there are: the plain R, G, B, diffuse, glossy"
    with pytest.raises(etendue.FileError, match=re.escape(f"{b}: {listed}")):
        etendue.compare(b, b, layer="Diffuse")


def test_which_of_several(good: Path, tmp_path: Path) -> None:
    b = write_channels(tmp_path / "b.exr", rgb(1, "diffuse.") | rgb(1, "glossy."))
    with pytest.raises(etendue.FileError, match=r"one layer must be chosen.* diffuse, glossy"):
        etendue.compare(good, b)


@pytest.mark.parametrize(
    "parts",
    [
        {"": rgb() | rgb(0.01, "variance.")},
        {"": rgb(1, "Beauty.") | rgb(0.01, "Beauty.variance.")},
        {"": rgb(1, "Beauty.") | rgb(0.01, "variance.")},
        {"rgba": rgb(), "variance": rgb(0.01)},
        {"rgba": rgb(), "variance": rgb(0.01, "variance.")},
    ],
)
def test_variance_is_found(tmp_path: Path, parts: dict[str, dict[str, FloatPlane]]) -> None:
    a = write_parts(tmp_path / "a.exr", parts)
    found = etendue.compare(a, a)
    assert found.a.variance == pytest.approx(0.01 * scene(), rel=1e-6)


def test_variance_of_the_picture_is_not_that_of_a_layer(tmp_path: Path) -> None:
    a = write_channels(tmp_path / "a.exr", rgb() | rgb(0.5, "diffuse.") | rgb(0.01, "variance."))
    assert etendue.compare(a, a, layer="diffuse").a.variance is None


def test_luminance_alone_is_grey(good: Path, tmp_path: Path) -> None:
    b = write_channels(tmp_path / "b.exr", {"Y": rgb()["G"]})
    color = etendue.compare(good, b).b.color
    assert (color == rgb()["G"][..., None]).all()


@pytest.mark.parametrize("storage", ["scanlineimage", "tiledimage"])
@pytest.mark.parametrize("number", [np.float16, np.float32])
@pytest.mark.parametrize("compression", ["NO", "ZIP", "PIZ", "DWAA"])
def test_storage(
    good: Path, tmp_path: Path, storage: str, number: type[np.floating], compression: str
) -> None:
    """DWAA loses a little."""
    header = {
        "compression": getattr(OpenEXR, f"{compression}_COMPRESSION"),
        "type": getattr(OpenEXR, storage),
    }
    if storage == "tiledimage":
        header["tiles"] = OpenEXR.TileDescription()
    planes = {name: plane.astype(number) for name, plane in rgb().items()}
    b = write_channels(tmp_path / "b.exr", planes, **header)
    assert etendue.compare(good, b).b.color == pytest.approx(scene(), rel=0.05)


def test_one_file_without_variance(tmp_path: Path) -> None:
    a = write_color(tmp_path / "a.exr", noisy(scene(), 0.02, 1))
    b = write_parts(tmp_path / "b.exr", {"rgba": rgb(), "variance": rgb(0.01)})
    assert etendue.compare(a, b).whole.method == "jackknife"
