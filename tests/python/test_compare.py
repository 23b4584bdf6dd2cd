"""etendue.compare: pictures that can be compared, and others."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np
import pytest

import etendue
from etendue.comparison import distance
from etendue.comparison.distance import mean_relative_squared_error, relative_squared_error
from etendue.comparison.figures import figures
from support.compared_pictures import HEIGHT, WATER, WIDTH, FloatArray, noisy, scene
from support.exr_file import write_channels, write_color
from support.stage_builder import StageBuilder


@pytest.fixture
def good(tmp_path: Path) -> Path:
    """Without variance."""
    return write_color(tmp_path / "a.exr", noisy(scene(), 0.02, 1))


def caustic(color: FloatArray, factor: float) -> FloatArray:
    """The bright patch alone scaled."""
    scaled = color.copy()
    scaled[8:16, 9:27] *= factor
    return scaled


# ------------------------------------------------------------------------------------ good pictures


def test_a_picture_and_itself(good: Path) -> None:
    found = etendue.compare(good, good)
    assert found.whole.value == found.brightest.value == 1
    assert found.b_from_a.rel_mse == 0
    assert found.b_from_a.flip == pytest.approx(0, abs=1e-6)
    assert (found.ratio_map == 1).all()
    assert found.z_scores is None
    assert found.sentence == "A and B are the same in every pixel."


def test_water_is_named(good: Path, tmp_path: Path) -> None:
    b = write_color(tmp_path / "b.exr", noisy(scene() * WATER, 0.02, 2))
    found = etendue.compare(good, b)
    assert found.whole.method == "jackknife"
    assert found.whole.pixels == HEIGHT * WIDTH
    assert WATER in found.brightest
    assert re.match(
        r"B is 1\.7\d+ ± 0\.0\d+ × as bright as A in the brightest 5 % of the pixels "
        r"and 1\.7\d+ ± 0\.0\d+ × over the whole picture \(95% confidence each\): "
        r"possibly one uncancelled η² = 1\.777 \(η = 1\.333, water\)\.$",
        found.sentence,
    )


def test_error_in_the_caustic_alone(good: Path, tmp_path: Path) -> None:
    b = write_color(tmp_path / "b.exr", noisy(caustic(scene(), 2.25), 0.02, 2))
    found = etendue.compare(good, b, good)
    patch = np.zeros((HEIGHT, WIDTH), dtype=bool)
    patch[8:16, 9:27] = True
    assert not found.brightest_region[~patch].any()
    assert 2.25 in found.brightest
    assert "2.25 (η = 1.5, glass)" in found.sentence
    assert found.whole.value < 2
    assert np.median(found.ratio_map[patch]) == pytest.approx(2.25, rel=0.02)
    assert np.median(found.ratio_map[~patch]) == pytest.approx(1, rel=0.01)


def test_variance_gives_z_scores_and_intervals(tmp_path: Path) -> None:
    color = scene()
    variance = (0.1 * color) ** 2
    a = write_color(tmp_path / "a.exr", noisy(color, 0.1, 1), variance)
    b = write_color(tmp_path / "b.exr", noisy(color * 2.25, 0.1, 2), variance * 2.25**2)
    found = etendue.compare(a, b)
    assert found.whole.method == found.brightest.method == "variance"
    assert 2.25 in found.brightest
    assert found.z_scores is not None
    # 1.25 of a pixel over its standard error, 0.1 sqrt(1 + 2.25^2).
    assert np.mean(found.z_scores) == pytest.approx(1.25 / 0.1 / np.sqrt(1 + 2.25**2), rel=0.02)
    assert "glass" in found.sentence
    told = dict(figures(found))
    assert "(95%, variance channels, 1,536 pixels)" in told["mean B / A"]
    assert re.match(r"\d+\.\d\d% of pixels' channels beyond ±3", told["z-scores"])


def test_intervals_count_with_splats(tmp_path: Path) -> None:
    """The same noise spread over 2 x 2 pixels is as sure as before, though each pixel's variance is
    a quarter: from that alone both intervals would be half as wide."""
    color = np.ones((64, 64, 3))
    halves = []
    for name in ("sharp", "spread"):
        files = []
        for seed in (1, 2):
            noise = np.random.default_rng(seed).normal(0, 0.1, (64, 64, 1))
            if name == "spread":
                shifts = [(y, x) for y in (0, 1) for x in (0, 1)]
                noise = np.mean([np.roll(noise, shift, (0, 1)) for shift in shifts], axis=0)
            variance = np.full_like(color, 0.01 if name == "sharp" else 0.0025)
            files.append(write_color(tmp_path / f"{name}{seed}.exr", color + noise, variance))
        found = etendue.compare(*files)
        halves.append([r.high - r.low for r in (found.whole, found.brightest)])
    assert halves[1] == pytest.approx(halves[0], rel=0.15)


def test_z_scores_of_exact_pixels(tmp_path: Path) -> None:
    color = scene()
    other = color.copy()
    other[0, 0, 0] += 1
    a = write_color(tmp_path / "a.exr", color, np.zeros_like(color))
    b = write_color(tmp_path / "b.exr", other, np.zeros_like(color))
    scores = etendue.compare(a, b).z_scores
    assert scores is not None
    assert scores[0, 0, 0] == np.inf
    assert np.count_nonzero(scores) == 1


def test_variance_of_one_file_is_not_enough(good: Path, tmp_path: Path) -> None:
    b = write_color(tmp_path / "b.exr", scene(), np.full_like(scene(), 1e-4))
    found = etendue.compare(good, b)
    assert found.whole.method == "jackknife"
    assert found.z_scores is None


def test_variance_that_is_not_known(tmp_path: Path) -> None:
    file = write_color(tmp_path / "a.exr", scene(), np.full_like(scene(), np.inf))
    assert etendue.compare(file, file).z_scores is None


def test_noise_hides_the_ratio(tmp_path: Path) -> None:
    color = scene()
    a = write_color(tmp_path / "a.exr", color, (1e3 * color) ** 2)
    b = write_color(tmp_path / "b.exr", 2 * color, (1e3 * color) ** 2)
    found = etendue.compare(a, b)
    assert not found.whole.known
    assert "noise hides the ratio over the whole picture" in found.sentence


def test_reference(good: Path, tmp_path: Path) -> None:
    reference = write_color(tmp_path / "r.exr", scene())
    b = write_color(tmp_path / "b.exr", scene() * 1.5)
    found = etendue.compare(good, b, reference)
    assert found.a_from_reference is not None
    assert found.b_from_reference is not None
    assert found.a_from_reference.rel_mse == pytest.approx(0.02**2, rel=0.2)
    exact = relative_squared_error(scene() * 1.5, scene()).mean()
    assert found.b_from_reference.rel_mse == pytest.approx(exact, rel=1e-5)
    assert found.a_from_reference.flip is not None
    assert found.b_from_reference.flip is not None
    assert found.b_from_reference.flip > 3 * found.a_from_reference.flip


def test_rel_mse_by_hand() -> None:
    reference = np.array([[[1.0, 1.0, 1.0], [3.0, 3.0, 3.0]]])
    image = np.array([[[1.0, 1.0, 4.0], [3.0, 3.0, 3.0]]])
    relative = relative_squared_error(image, reference)
    assert relative[0, 0] == pytest.approx((9 / 3) / (1 + (0.02 * 2) ** 2))
    assert relative[0, 1] == 0


def test_black_pixels_have_no_ratio(tmp_path: Path) -> None:
    color = scene()
    color[0, 0] = 0
    a = write_color(tmp_path / "a.exr", color)
    b = write_color(tmp_path / "b.exr", scene())
    ratios = etendue.compare(a, b).ratio_map
    assert np.isnan(ratios[0, 0])
    assert np.count_nonzero(np.isnan(ratios)) == 1


def test_one_pixel(tmp_path: Path) -> None:
    file = write_color(tmp_path / "a.exr", np.ones((1, 1, 3)))
    found = etendue.compare(file, file)
    assert found.whole.value == 1
    assert not found.whole.known


def test_our_own_renders(build: StageBuilder, tmp_path: Path) -> None:
    stage = etendue.open(build.lit_quad().stage)
    files = [tmp_path / "a.exr", tmp_path / "b.exr"]
    for seed, file in enumerate(files):
        stage.render(resolution=(32, 24), spp=16, seed=seed, aovs=["variance"]).save(file)
    found = etendue.compare(*files)
    assert found.whole.method == "variance"
    assert found.z_scores is not None
    # Five standard errors; the interval has 1.96.
    assert abs(found.whole.value - 1) < 5 / 1.96 * (found.whole.high - found.whole.value)


# ---------------------------------------------------------------------------------------- refusals


def test_sizes(good: Path, tmp_path: Path) -> None:
    b = write_color(tmp_path / "b.exr", scene()[:, 1:])
    with pytest.raises(etendue.ComparisonError, match="sizes are 48x32 and 47x32") as refused:
        etendue.compare(good, b)
    assert str(good) in str(refused.value)
    assert str(b) in str(refused.value)
    with pytest.raises(etendue.ComparisonError, match=re.escape(str(b))):
        etendue.compare(good, good, b)


def test_crops_of_different_places(build: StageBuilder, tmp_path: Path) -> None:
    stage = etendue.open(build.lit_quad().stage)
    files = [tmp_path / "a.exr", tmp_path / "b.exr"]
    for x, file in enumerate(files):
        stage.render(resolution=(16, 12), spp=1, crop=(x, 2, x + 8, 10)).save(file)
    with pytest.raises(etendue.ComparisonError, match=r"crops at \(0, 2\) and \(1, 2\)"):
        etendue.compare(*files)


def test_black(good: Path, tmp_path: Path) -> None:
    b = write_color(tmp_path / "b.exr", np.zeros_like(scene()))
    with pytest.raises(etendue.ComparisonError, match=f"{re.escape(str(b))}: is black"):
        etendue.compare(good, b)


def refused(good: Path, bad: Path) -> str:
    """What both orders of the arguments say, after the name of the bad file."""
    messages = set()
    for pair in ((good, bad), (bad, good)):
        with pytest.raises(etendue.FileError) as error:
            etendue.compare(*pair)
        messages.add(str(error.value))
    (message,) = messages
    assert message.startswith(f"{bad}: ")
    return message.removeprefix(f"{bad}: ")


def test_missing(good: Path, tmp_path: Path) -> None:
    assert refused(good, tmp_path / "missing.exr") == "no such file or directory"


def test_a_folder(good: Path, tmp_path: Path) -> None:
    assert refused(good, tmp_path) == "is a directory"


@pytest.mark.parametrize("content", [b"", b"PNG", b"hello, this is no picture"])
def test_not_an_exr(good: Path, tmp_path: Path, content: bytes) -> None:
    bad = tmp_path / "b.exr"
    bad.write_bytes(content)
    assert refused(good, bad) == "not an OpenEXR file"


@pytest.mark.parametrize("kept", [4, 40, 0.5, 0.99])
def test_cut_off(good: Path, tmp_path: Path, kept: float) -> None:
    whole = good.read_bytes()
    bad = tmp_path / "b.exr"
    bad.write_bytes(whole[: kept if isinstance(kept, int) else int(kept * len(whole))])
    assert re.match("cannot be read|corrupt", refused(good, bad))


def test_scrambled_pixels(good: Path, tmp_path: Path) -> None:
    content = bytearray(good.read_bytes())
    middle = len(content) // 2
    content[middle : middle + 200] = bytes(200)
    bad = tmp_path / "b.exr"
    bad.write_bytes(content)
    assert re.match("cannot be read|corrupt", refused(good, bad))


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_not_finite(good: Path, tmp_path: Path, value: float) -> None:
    color = scene()
    color[3, 5, 1] = value
    bad = write_color(tmp_path / "b.exr", color)
    where = "in column 5, row 3 (from 0, row 0 on top)"
    how_many = "not finite: 1 of 1,536 pixels"
    assert refused(good, bad) == f"channel G is {value} {where}; {how_many}"


def test_not_finite_in_a_crop(tmp_path: Path) -> None:
    """Columns and rows are the image's, as viewers show them."""
    plane = np.ones((HEIGHT, WIDTH), np.float32)
    hole = plane.copy()
    hole[3, 5] = hole[4, 5] = np.nan
    bad = tmp_path / "b.exr"
    write_channels(bad, {"R": plane, "G": plane, "B": hole}, dataWindow=_window(10, 20))
    where = r"channel B is nan in column 15, row 23 .*2 of 1,536 pixels"
    with pytest.raises(etendue.FileError, match=where):
        etendue.compare(bad, bad)


def _window(x: int, y: int) -> tuple[tuple[int, int], tuple[int, int]]:
    return (x, y), (x + WIDTH - 1, y + HEIGHT - 1)


def test_negative_pixels(good: Path, tmp_path: Path) -> None:
    """Filters with negative lobes leave them: they count in the sums."""
    color = scene()
    color[0, 0] = -1
    found = etendue.compare(good, write_color(tmp_path / "b.exr", color))
    assert found.whole.value < 1
    assert found.ratio_map[0, 0] < 0
    dark = write_color(tmp_path / "dark.exr", -scene())
    with pytest.raises(etendue.ComparisonError, match="is black"):
        etendue.compare(good, dark)


def test_primaries(good: Path, tmp_path: Path) -> None:
    """Missing ones are Rec.709's; the rounding of 32-bit floats is no difference."""
    planes = {name: scene()[..., i].astype(np.float32) for i, name in enumerate("RGB")}
    rec709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
    same = write_channels(tmp_path / "same.exr", planes, chromaticities=rec709)
    etendue.compare(good, same)
    p3 = (0.68, 0.32, 0.265, 0.69, 0.15, 0.06, 0.3127, 0.3290)
    other = write_channels(tmp_path / "p3.exr", planes, chromaticities=p3)
    with pytest.raises(etendue.ComparisonError, match=r"primaries .* differ"):
        etendue.compare(good, other)


def test_flip_only_when_asked_or_cheap(good: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert etendue.compare(good, good, flip=False).b_from_a.flip is None
    monkeypatch.setattr(distance, "FLIP_PIXELS", HEIGHT * WIDTH - 1)
    found = etendue.compare(good, good, good)
    assert found.b_from_reference is not None
    assert found.b_from_a.flip is found.b_from_reference.flip is None
    assert "FLIP not measured" in dict(figures(found))["B from A"]
    assert etendue.compare(good, good, flip=True).b_from_a.flip is not None


def test_rel_mse_in_bands_is_that_of_the_whole() -> None:
    random = np.random.default_rng(0)
    image, reference = random.random((2, 150, 3, 3))
    expected = relative_squared_error(image, reference).mean()
    assert mean_relative_squared_error(image, reference) == pytest.approx(expected, rel=1e-12)


def test_indices_that_cannot_be(good: Path) -> None:
    for index in (0, 1, -1.5, np.nan, np.inf):
        with pytest.raises(etendue.SettingsError, match="index of refraction"):
            etendue.compare(good, good, indices=[1.5, index])


def test_variance_not_finite(good: Path, tmp_path: Path) -> None:
    variance = np.ones_like(scene())
    variance[3, 5, 1] = np.inf
    bad = write_color(tmp_path / "b.exr", scene(), variance)
    assert refused(good, bad).startswith("channel variance.G is inf in column 5, row 3")


def test_negative_variance(good: Path, tmp_path: Path) -> None:
    bad = write_color(tmp_path / "b.exr", scene(), -np.ones_like(scene()))
    assert refused(good, bad) == "holds a negative variance"


def test_no_color(good: Path, tmp_path: Path) -> None:
    plane = np.ones((HEIGHT, WIDTH), np.float32)
    bad = write_channels(tmp_path / "b.exr", {"G": plane, "depth.Z": plane})
    assert refused(good, bad) == "has no channels R, G, B; there are: G, depth.Z"


def test_half_floats_are_read(good: Path, tmp_path: Path) -> None:
    planes = {name: scene()[..., i].astype(np.float16) for i, name in enumerate("RGB")}
    b = write_channels(tmp_path / "b.exr", {n: np.ascontiguousarray(p) for n, p in planes.items()})
    assert etendue.compare(good, b).whole.value == pytest.approx(1, rel=0.01)


def test_missing_extra(good: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "OpenEXR", None)
    told = r"'OpenEXR' is not installed.*etendue\[report\]"
    with pytest.raises(etendue.Error, match=told) as raised:
        etendue.compare(good, good)
    assert not isinstance(raised.value, etendue.FileError)  # nothing is wrong with the file
