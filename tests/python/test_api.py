"""etendue.open(...).render(...): what people write."""

from __future__ import annotations

import os
import signal
import threading
import time
from dataclasses import asdict
from itertools import pairwise
from pathlib import Path
from typing import Any, Unpack

import numpy as np
import pytest
from PIL import Image as PilImage
from pxr import Gf, Usd, UsdGeom, UsdRender

import etendue
from etendue.presets import PRESETS
from etendue.settings import RenderOptions, render_settings
from support.exr_header import read_exr_header
from support.stage_builder import StageBuilder

SMALL: Any = {"resolution": (16, 12), "spp": 2}


@pytest.fixture
def stage(build: StageBuilder) -> etendue.Stage:
    """A lit quad."""
    return etendue.open(build.lit_quad().stage)


@pytest.fixture
def file(build: StageBuilder, tmp_path: Path) -> Path:
    """The same in a file."""
    path = tmp_path / "quad.usda"
    build.lit_quad().stage.Export(str(path))
    return path


# ------------------------------------------------------------------------------------------- open


def test_six_lines(file: Path, tmp_path: Path) -> None:
    stage = etendue.open(file)
    image = stage.render(resolution=(16, 12), spp=1)
    image.save(tmp_path / "quad.png")
    with PilImage.open(tmp_path / "quad.png") as picture:
        assert picture.size == (16, 12)


def test_open_tells_what_it_has(stage: etendue.Stage) -> None:
    assert stage.cameras == ("/Camera",)
    assert stage.frame == 0
    assert stage.warnings == ()
    assert "Stage" in repr(stage)


def test_open_warns(build: StageBuilder) -> None:
    build.lit_quad().quad("/Bad", points=[])
    with pytest.warns(etendue.EtendueWarning, match="/Bad: the mesh is skipped") as caught:
        stage = etendue.open(build.stage)
    assert caught[0].filename == __file__
    assert [warning.path for warning in stage.warnings] == ["/Bad"]


def test_open_at_a_frame(build: StageBuilder) -> None:
    positions = build.lit_quad().stage.GetPrimAtPath("/Camera").GetAttribute("xformOp:translate")
    positions.Set((0.5, 0.5, 5), 1.0)
    positions.Set((0.5, 0.5, 7), 3.0)
    stage = etendue.open(build.stage, frame=2)
    depth = stage.render(**SMALL, aovs=["depth"])["depth"]
    assert depth[6, 8] == pytest.approx(6)


# ------------------------------------------------------------------------------------------ images


def test_image(stage: etendue.Stage) -> None:
    image = stage.render(**SMALL, aovs=["alpha", "depth", "normal"])
    assert (image.width, image.height) == (16, 12)
    assert image.full_size == (16, 12)
    assert image.window == (0, 0, 16, 12)
    assert image.aovs == ("color", "alpha", "depth", "normal")
    assert "depth" in image
    assert "albedo" not in image
    assert image.color.shape == (12, 16, 3)
    assert image["depth"].shape == (12, 16)
    assert image["depth"].dtype == np.float32
    assert image.statistics.passes == 2
    assert image.statistics.camera_paths >= 2 * 16 * 12
    assert set(image.statistics.invalid) == {"nan", "infinite", "negative"}
    with pytest.raises(KeyError, match=r"no AOV 'albedo'.*color, alpha, depth, normal"):
        image["albedo"]


def test_color_is_always_there(stage: etendue.Stage) -> None:
    assert stage.render(**SMALL, aovs=["depth"]).aovs == ("color", "depth")


def test_changing_an_array_changes_nothing_else(stage: etendue.Stage) -> None:
    image = stage.render(**SMALL)
    image.color[:] = 7
    assert image.color.max() < 7


def test_strategy_images(stage: etendue.Stage) -> None:
    image = stage.render(**SMALL, max_depth=1, strategy_images=2)
    shares = [name for name in image.strategy_images if name.startswith("st.weighted.")]
    assert shares == [f"st.weighted.s{s}t{t}" for s, t in ((0, 2), (1, 1), (0, 3), (1, 2), (2, 1))]
    assert "st.unweighted.s1t2" in image
    assert image["st.unweighted.s1t2"].shape == (12, 16, 3)
    np.testing.assert_allclose(sum(image[name] for name in shares), image.color, rtol=1e-5)
    with pytest.raises(KeyError, match=r"no AOV 'st.weighted.s9t9'.*st.weighted.s0t2"):
        image["st.weighted.s9t9"]


def test_crop_is_part_of_the_whole(stage: etendue.Stage) -> None:
    whole = stage.render(**SMALL, aovs=["depth"])
    part = stage.render(**SMALL, aovs=["depth"], crop=(4, 3, 10, 11))
    assert part.window == (4, 3, 10, 11)
    assert part.full_size == (16, 12)
    assert part.color.shape == (8, 6, 3)
    np.testing.assert_array_equal(
        np.isfinite(part["depth"]), np.isfinite(whole["depth"][3:11, 4:10])
    )


@pytest.mark.parametrize("integrator", ["path", "light", "bdpt", "auto"])
def test_seed_and_threads(stage: etendue.Stage, integrator: str) -> None:
    options: Any = {**SMALL, "integrator": integrator, "spp": 4}
    one = stage.render(**options, seed=5, threads=1)
    two = stage.render(**options, seed=5, threads=2)
    other = stage.render(**options, seed=6)
    np.testing.assert_array_equal(one.color, two.color)
    assert (one.color != other.color).any()


def test_integrators_agree(stage: etendue.Stage) -> None:
    means = [
        stage.render(resolution=(8, 6), spp=2048, integrator=name).color.mean()
        for name in ("path", "light", "bdpt", "auto")
    ]
    assert max(means) == pytest.approx(min(means), rel=0.1)
    assert min(means) > 0


def test_auto_tells_what_it_chose(stage: etendue.Stage) -> None:
    """One lamp over one matte square: a render long enough for a pilot traces paths from the camera
    alone, a short one does without a pilot."""
    brief = stage.render(**SMALL, integrator="auto")
    assert brief.metadata["etendue:integrator"] == "auto"
    assert brief.metadata["etendue:chosen"] == "--integrator bdpt"
    np.testing.assert_array_equal(brief.color, stage.render(**SMALL).color)

    options: Any = {"resolution": (500, 500), "spp": 8, "max_depth": 2}
    long = stage.render(**options, integrator="auto")
    assert long.metadata["etendue:chosen"] == "--integrator path"
    assert long.statistics.chosen is not None
    assert long.statistics.chosen.light_paths_per_pixel is None
    assert long.statistics.light_paths == 0
    fixed = stage.render(**options, integrator="path")
    assert fixed.statistics.chosen is None
    assert "etendue:chosen" not in fixed.metadata
    np.testing.assert_array_equal(long.color, fixed.color)


def test_max_depth_0_shows_emission_only(build: StageBuilder) -> None:
    UsdGeom.XformCommonAPI(build.lit_quad().stage.GetPrimAtPath("/Light")).SetTranslate(
        Gf.Vec3d(0.5, 0.5, 2)
    )
    color = etendue.open(build.stage).render(**SMALL, max_depth=0, integrator="path").color
    np.testing.assert_allclose(color[6, 8], [50, 50, 50], rtol=1e-5)
    assert color[0, 0].max() == 0


def test_time_limit(stage: etendue.Stage) -> None:
    started = time.monotonic()
    image = stage.render(resolution=(16, 12), time=0.3)
    assert time.monotonic() - started < 30
    assert image.statistics.passes > 2


def test_error_target(stage: etendue.Stage) -> None:
    """Alone it sets no limit to samples; with one, whichever comes first counts."""
    rough = stage.render(resolution=(16, 12), error=0.04)
    fine = stage.render(resolution=(16, 12), error=0.02)
    assert 0.02 < rough.statistics.error < 0.04
    assert 0.01 < fine.statistics.error < 0.02
    assert fine.statistics.passes > rough.statistics.passes
    few = stage.render(resolution=(16, 12), error=1e-6, spp=10).statistics
    assert few.passes == 10
    assert 0.01 < few.error < np.inf
    brief = stage.render(resolution=(16, 12), error=1e-6, time=0.2).statistics
    assert brief.seconds >= 0.2


@pytest.mark.parametrize(
    ("integrator", "places"), [("path", True), ("bdpt", True), ("light", False)]
)
def test_adaptive(stage: etendue.Stage, integrator: str, places: bool) -> None:
    options: Any = {"resolution": (64, 48), "spp": 24, "integrator": integrator}
    counts = stage.render(**options, adaptive=True, aovs=["sample_count"])["sample_count"]
    assert (counts.min() < counts.max()) == places
    even = stage.render(**options, aovs=["sample_count"])["sample_count"]
    assert even.min() == even.max() == 24


def test_error_is_unknown_unless_asked_for(stage: etendue.Stage) -> None:
    image = stage.render(resolution=(16, 12), spp=8)
    assert image.statistics.error == np.inf
    assert "etendue:error" not in image.metadata
    known = stage.render(resolution=(16, 12), spp=8, aovs=["variance"])
    assert known.statistics.error < np.inf
    assert known.metadata["etendue:error"] == f"{known.statistics.error:.4g}"


def test_error_shows_in_progress(stage: etendue.Stage) -> None:
    told: list[etendue.RenderProgress] = []
    image = stage.render(resolution=(16, 12), error=0.1, progress=told.append)
    assert told[0].error == np.inf
    assert told[0].fraction == 0
    assert told[-1].error == image.statistics.error
    assert told[-1].fraction == 1
    assert {progress.passes_total for progress in told} == {0}


@pytest.mark.parametrize("name", PRESETS)
def test_preset(build: StageBuilder, name: str) -> None:
    """Options that are given win, one by one; those that are None are not."""
    contents = build.lit_quad().read()

    def settings(**options: Unpack[RenderOptions]) -> dict[str, float]:
        made = render_settings(contents, None, {"preset": name, **options})
        return {
            "error": made.error_target,
            "max_depth": made.max_depth,
            "spp": made.samples_per_pixel,
            "time": made.time_limit,
        }

    plain = {**asdict(PRESETS[name]), "time": 0.0}
    assert settings() == plain
    assert settings(error=None, max_depth=None, spp=None, time=None) == plain
    assert settings(error=0.5) == plain | {"error": 0.5}
    assert settings(max_depth=0) == plain | {"max_depth": 0}
    assert settings(spp=0) == plain | {"spp": 0}
    assert settings(time=3.0) == plain | {"time": 3.0}


def test_presets_ask_for_more_and_more() -> None:
    presets = list(PRESETS.values())
    for coarse, fine in pairwise(presets):
        assert fine.error < coarse.error
        assert fine.max_depth > coarse.max_depth
        assert fine.spp > coarse.spp


def test_wrong_on_purpose(stage: etendue.Stage) -> None:
    stage.render(**SMALL, adjoint=["refraction"], strategies=["emission_hit", "direct_light"])


# -------------------------------------------------------------------------------------- resolution


def test_default_resolution_has_the_cameras_aspect(build: StageBuilder) -> None:
    build.lit_quad().stage.GetPrimAtPath("/Camera").GetAttribute("verticalAperture").Set(20.955)
    with etendue.open(build.stage).session(spp=1, crop=(0, 0, 4, 4)) as session:
        session.wait()
        assert session.snapshot().full_size == (960, 960)
        assert session.pixels == 16


def test_render_settings_are_followed(build: StageBuilder) -> None:
    build.lit_quad().camera("/Other")
    settings = UsdRender.Settings.Define(build.stage, "/Render")
    build.stage.SetMetadata("renderSettingsPrimPath", "/Render")
    settings.CreateCameraRel().SetTargets(["/Other"])
    settings.CreateResolutionAttr(Gf.Vec2i(20, 10))
    # The lower left quarter.
    settings.CreateDataWindowNDCAttr(Gf.Vec4f(0, 0, 0.5, 0.5))
    stage = etendue.open(build.stage)
    image = stage.render(spp=1)
    assert image.full_size == (20, 10)
    assert image.window == (0, 5, 10, 10)
    assert image.metadata["etendue:camera"] == "/Other"
    explicit = stage.render("/Camera", resolution=(8, 4), spp=1, crop=(0, 0, 8, 4))
    assert explicit.window == (0, 0, 8, 4)
    assert explicit.metadata["etendue:camera"] == "/Camera"


# ------------------------------------------------------------------------------------------ errors


def test_no_camera(build: StageBuilder) -> None:
    build.quad()
    build.light()
    with pytest.raises(etendue.SceneError, match="the stage has no camera"):
        etendue.open(build.stage).render()


def test_no_light(build: StageBuilder) -> None:
    build.quad()
    build.camera()
    build.light(intensity=0.0)
    stage = etendue.open(build.stage)
    with pytest.raises(etendue.SceneError, match="no light") as caught:
        stage.render()
    assert stage.source in str(caught.value)


def test_emitting_surface_is_light_enough(build: StageBuilder) -> None:
    build.camera()
    build.bind(build.quad(), build.material(emissiveColor=(3.0, 2.0, 1.0)))
    color = etendue.open(build.stage).render(**SMALL, max_depth=0, integrator="path").color
    np.testing.assert_allclose(color[6, 8], [3, 2, 1], rtol=1e-5)


@pytest.mark.parametrize("camera", ["/Nowhere", "/Quad", "nobody"])
def test_unknown_camera(build: StageBuilder, camera: str) -> None:
    build.lit_quad().camera("/Other")
    with pytest.raises(etendue.SettingsError, match=r"not a camera.*/Camera, /Other"):
        etendue.open(build.stage).render(camera)


def test_camera_by_name(build: StageBuilder) -> None:
    build.lit_quad().camera("/cameras/top")
    image = etendue.open(build.stage).render("top", **SMALL)
    assert image.metadata["etendue:camera"] == "/cameras/top"


@pytest.mark.parametrize("integrator", ["path", "light", "bdpt"])
def test_orthographic_camera(build: StageBuilder, integrator: str) -> None:
    build.lit_quad().camera(
        "/Ortho", projection="orthographic", horizontalAperture=5.0, verticalAperture=5.0
    )
    image = etendue.open(build.stage).render(
        "/Ortho", resolution=(8, 8), spp=64, integrator=integrator, aovs=["depth"]
    )
    # The window lies within the quad, which is 5 units away wherever one looks.
    np.testing.assert_allclose(image["depth"], 5, rtol=1e-6)
    assert image.color.mean() > 0


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"integrator": "magic"}, "unknown integrator 'magic'; there are: path, light, bdpt, auto"),
        ({"aovs": ["beauty"]}, "unknown aov 'beauty'; there are: color, alpha"),
        ({"filter": "sinc"}, "unknown filter 'sinc'"),
        ({"heuristic": "gut"}, "unknown heuristic 'gut'"),
        ({"strategies": ["luck"]}, "unknown strategy 'luck'"),
        ({"adjoint": ["fog"]}, "unknown adjoint correction 'fog'"),
        ({"resolution": (0, 5)}, "resolution is 0"),
        ({"crop": (0, 0, 17, 5)}, "crop 0,0,17,5 is empty or outside of the image of 16x12"),
        ({"crop": (5, 5, 5, 6)}, "crop 5,5,5,6 is empty"),
        ({"spp": -1}, "spp is -1"),
        ({"spp": 0}, "never end"),
        ({"time": -1.0}, "time is -1.0"),
        ({"time": float("nan")}, "time is nan"),
        ({"preset": "best"}, "unknown preset 'best'; there are: draft, preview, final, reference"),
        ({"preset": "draft", "max_depth": -1}, "max_depth is -1"),
        ({"error": 0.0}, "error is 0.0"),
        ({"error": -0.1}, "error is -0.1"),
        ({"error": float("nan")}, "error is nan"),
        ({"error": float("inf")}, "error is inf"),
        ({"max_depth": -1}, "max_depth is -1"),
        ({"threads": -1}, "threads is -1"),
    ],
)
def test_bad_options(stage: etendue.Stage, options: Any, message: str) -> None:
    with pytest.raises(etendue.SettingsError, match=message):
        stage.render(**({"resolution": (16, 12)} | options))


def test_missing_file(tmp_path: Path) -> None:
    with pytest.raises(etendue.FileError, match=r"missing\.usda: no such file"):
        etendue.open(tmp_path / "missing.usda")


def test_unreadable_texture_does_not_crash(build: StageBuilder, tmp_path: Path) -> None:
    from pxr import Sdf

    from support.stage_builder import Types

    picture = tmp_path / "broken.png"
    picture.write_bytes(b"no picture")
    build.lit_quad()
    build.bind(build.stage.GetPrimAtPath("/Quad"), build.material())
    node = build.node("UsdUVTexture", "/Material/Texture", file=Sdf.AssetPath(str(picture)))
    surface = build.node("UsdPreviewSurface", "/Material/Surface")
    surface.CreateInput("diffuseColor", Types.Color3f).ConnectToSource(
        node.CreateOutput("rgb", Types.Float3)
    )
    with pytest.raises(etendue.FileError, match=r"broken\.png"):
        etendue.open(build.stage).render(**SMALL)


# ------------------------------------------------------------------------------------------- files


def test_exr(stage: etendue.Stage, tmp_path: Path) -> None:
    file = tmp_path / "a.exr"
    image = stage.render(**SMALL, seed=9, aovs=["alpha", "depth"], crop=(2, 3, 10, 11))
    image.save(file)
    header = read_exr_header(file)
    assert header["channels"] == ["A", "B", "G", "R", "depth.Z"]
    assert header["dataWindow"] == (2, 3, 9, 10)
    assert header["displayWindow"] == (0, 0, 15, 11)
    assert header["Software"] == f"Etendue {etendue.__version__}"
    assert header["etendue:version"] == etendue.__version__
    assert header["etendue:seed"] == "9"
    assert header["etendue:spp"] == "2"
    assert header["etendue:integrator"] == "bdpt"
    assert header["etendue:camera"] == "/Camera"
    assert header["etendue:stage"] == stage.source
    assert float(str(header["etendue:seconds"])) >= 0


@pytest.mark.parametrize(
    ("name", "bits"), [("a.png", 8), ("a.png", 16), ("a.tif", 16), ("a.jpg", 8)]
)
def test_display_files(stage: etendue.Stage, tmp_path: Path, name: str, bits: int) -> None:
    file = tmp_path / name
    image = stage.render(**SMALL)
    image.save(file, bits=bits)
    assert file.stat().st_size > 50
    with PilImage.open(file) as picture:
        assert picture.size == (16, 12)


def test_display_values(stage: etendue.Stage, tmp_path: Path) -> None:
    file = tmp_path / "a.png"
    image = stage.render(**SMALL)
    image.save(file)
    shown = np.clip(image.for_display(), 0, 1)
    with PilImage.open(file) as picture:
        pixels = np.asarray(picture.convert("RGB"), dtype=np.float64) / 255
    np.testing.assert_allclose(pixels, shown, atol=1 / 255)


def test_files_that_cannot_be_written(stage: etendue.Stage, tmp_path: Path) -> None:
    image = stage.render(**SMALL)
    with pytest.raises(etendue.FileError, match="nowhere"):
        image.save(tmp_path / "nowhere" / "a.exr")
    with pytest.raises(etendue.SettingsError, match=r"a\.gif"):
        image.save(tmp_path / "a.gif")
    with pytest.raises(etendue.SettingsError, match="no such view"):
        image.save(tmp_path / "a.png", view="no such view")
    with pytest.raises(etendue.FileError, match=r"missing\.ocio"):
        image.save(tmp_path / "a.png", ocio=str(tmp_path / "missing.ocio"))
    assert list(tmp_path.iterdir()) == []


# ---------------------------------------------------------------------------------------- sessions


def test_session(stage: etendue.Stage) -> None:
    session = stage.session(resolution=(16, 12), spp=1_000_000)
    with session:
        while session.progress.passes_done < 2:
            time.sleep(0.001)
        first = session.snapshot()
        assert session.wait(0.05) is False
        session.cancel()
        assert session.wait(30) is True
        last = session.snapshot()
    assert first.statistics.passes >= 2
    assert last.statistics.passes >= first.statistics.passes
    assert last.metadata["etendue:spp"] == str(last.statistics.passes)


def test_progress_callback(stage: etendue.Stage) -> None:
    threads = set()
    stage.render(**SMALL, progress=lambda _: threads.add(threading.get_ident()))
    assert threads
    assert threading.get_ident() not in threads


def test_progress_callback_that_fails(stage: etendue.Stage) -> None:
    def fail(_: etendue.RenderProgress) -> None:
        raise LookupError("not my day")

    with pytest.raises(LookupError, match="not my day"):
        stage.render(resolution=(16, 12), spp=1_000_000, progress=fail)


@pytest.mark.usefixtures("ctrl_c_interrupts")
def test_ctrl_c_keeps_the_image(stage: etendue.Stage) -> None:
    pressed = threading.Event()
    first = 3

    def interrupt(progress: etendue.RenderProgress) -> None:
        if progress.passes_done >= first and not pressed.is_set():
            pressed.set()
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(etendue.Interrupted) as caught:
        stage.render(resolution=(16, 12), spp=1_000_000_000, progress=interrupt)
    assert caught.value.image.statistics.passes >= first
    assert caught.value.image.color.any()

    pressed.clear()
    first = 100
    with pytest.raises(etendue.Interrupted) as caught:
        stage.render(resolution=(16, 12), error=1e-9, progress=interrupt)
    assert caught.value.image.statistics.passes >= first
    assert 0 < float(caught.value.image.metadata["etendue:error"]) < 1


@pytest.mark.usefixtures("ctrl_c_interrupts")
def test_ctrl_c_at_bad_moments(stage: etendue.Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    """Before start() has returned, and again by an impatient hand while the render ends."""
    start, cancel = etendue.Session.start, etendue.Session.cancel
    impatience = iter(range(3))

    def interrupted_start(session: etendue.Session) -> None:
        start(session)
        signal.raise_signal(signal.SIGINT)

    def interrupted_cancel(session: etendue.Session) -> None:
        cancel(session)
        if next(impatience, None) is not None:
            signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(etendue.Session, "start", interrupted_start)
    monkeypatch.setattr(etendue.Session, "cancel", interrupted_cancel)
    with pytest.raises(etendue.Interrupted) as caught:
        stage.render(resolution=(16, 12), spp=1_000_000_000)
    assert caught.value.image.color.shape == (12, 16, 3)
    assert next(impatience, None) is None


def test_stage_outlives_the_usd_stage(build: StageBuilder) -> None:
    stage = etendue.open(build.lit_quad().stage)
    build.stage = Usd.Stage.CreateInMemory()
    stage.render(**SMALL)


def test_normals_are_those_of_shading() -> None:
    """A normal map shows in them, and takes nothing from their length."""
    stage = etendue.open(Path(__file__).parents[2] / "stages" / "bump_plane.usda")
    normal = stage.render(spp=1, resolution=(32, 24), max_depth=0, aovs=["normal"])["normal"]
    assert np.linalg.norm(normal, axis=-1) == pytest.approx(1, abs=1e-5)
    # The plane's own is (0, 1, 0); the map's slopes are up to 46 degrees, halved.
    assert 0.7 < normal[..., 1].min() < 0.95


@pytest.mark.parametrize("option", ["error", "time"])
def test_a_limit_that_is_no_number_is_refused(option: str) -> None:
    stage = etendue.open(StageBuilder().lit_quad().stage)
    with pytest.raises(etendue.SettingsError, match=f"{option} is x; it must be a positive number"):
        stage.render(**{option: "x"})  # type: ignore[arg-type]
