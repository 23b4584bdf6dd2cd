"""The extension module itself: arrays, lifetimes, threads."""

from __future__ import annotations

import gc
import threading
import time
from typing import Any

import numpy as np
import pytest

import etendue
from etendue import _core
from support.stage_builder import StageBuilder


@pytest.fixture
def scene(build: StageBuilder) -> _core.SceneDescription:
    """A lit quad."""
    return build.lit_quad().read().scene


def settings(**attributes: Any) -> _core.RenderSettings:
    """Small and short; `attributes` override."""
    return _core.RenderSettings(**{"width": 8, "height": 6, "samples_per_pixel": 2} | attributes)


def endless(**attributes: Any) -> _core.RenderSettings:
    """As good as endless."""
    return settings(samples_per_pixel=1_000_000_000, **attributes)


# ----------------------------------------------------------------------------------------- structs


def test_arrays_are_copied() -> None:
    points = np.zeros((3, 3), np.float32)
    mesh = _core.MeshDesc(points=points)
    points[0, 0] = 1
    mesh.points[1, 1] = 2
    assert not mesh.points.any()
    assert mesh.points.flags.owndata


def test_any_layout_and_type_of_numbers() -> None:
    mesh = _core.MeshDesc(points=np.arange(18.0).reshape(6, 3)[::2])
    np.testing.assert_array_equal(mesh.points[:, 0], [0, 6, 12])
    mesh.face_vertex_indices = np.arange(6, dtype=np.int64)[::-1]
    np.testing.assert_array_equal(mesh.face_vertex_indices, [5, 4, 3, 2, 1, 0])


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("points", np.zeros((3, 2))),
        ("points", np.zeros(3)),
        ("st", np.zeros((3, 3))),
        ("face_vertex_counts", np.zeros((2, 2), np.int32)),
        ("face_vertex_counts", np.array([3.5])),
        ("face_vertex_indices", np.array([2**40])),
    ],
)
def test_wrong_arrays(name: str, value: np.ndarray[Any, Any]) -> None:
    with pytest.raises(ValueError, match=r"expected an array|does not fit"):
        setattr(_core.MeshDesc(), name, value)


def test_unknown_keyword() -> None:
    with pytest.raises(TypeError, match="unexpected keyword argument 'radios'"):
        _core.SphereDesc(radios=2)  # type: ignore[call-arg]


def test_matrices() -> None:
    shape = _core.ShapeDesc(parent_from_object=np.arange(16.0).reshape(4, 4))
    np.testing.assert_array_equal(shape.parent_from_object[0], [0, 1, 2, 3])
    with pytest.raises(ValueError, match="shape"):
        shape.parent_from_object = np.eye(3)


def test_add_returns_the_index() -> None:
    scene = _core.SceneDescription()
    assert scene.add_geometry(_core.SphereDesc()) == 0
    assert scene.add_geometry(_core.MeshDesc()) == 1
    assert [type(item).__name__ for item in scene.geometries] == ["SphereDesc", "MeshDesc"]


def test_add_instances() -> None:
    scene = _core.SceneDescription()
    scene.add_instances("/I", 3, np.arange(32.0).reshape(2, 4, 4))
    first, second = scene.instances
    assert (first.name, second.name, second.group) == ("/I[0]", "/I[1]", 3)
    np.testing.assert_array_equal(second.world_from_group.ravel(), np.arange(16.0) + 16)
    with pytest.raises(ValueError, match=r"\(n, 4, 4\)"):
        scene.add_instances("/I", 0, np.eye(4))


def test_defaults_are_the_headers() -> None:
    assert _core.CameraDesc().horizontal_aperture == 20.955
    assert _core.RenderSettings().max_depth == 16
    assert _core.RenderSettings().crop is None


def test_errors_are_typed() -> None:
    for error in (etendue.SceneError, etendue.SettingsError, etendue.FileError):
        assert issubclass(error, etendue.Error)
    assert issubclass(etendue.Error, RuntimeError)
    with pytest.raises(etendue.SettingsError, match=r"a\.gif"):
        _core.image_file_kind("a.gif")
    with pytest.raises(etendue.FileError, match="nowhere"):
        _core.check_writable("/nowhere/a.exr")


# ----------------------------------------------------------------------------------------- images


def test_aov_arrays(scene: _core.SceneDescription) -> None:
    every = list(_core.Aov.__members__.values())
    session = _core.RenderSession(scene, settings(aovs=every))
    session.start()
    session.wait()
    image = session.snapshot()
    arrays = {aov.name: image.array(aov) for aov in every}
    del image, session
    gc.collect()
    for aov in every:
        channels = _core.aov_channels(aov)
        expected = (6, 8) if channels == 1 else (6, 8, channels)
        assert arrays[aov.name].shape == expected
        assert arrays[aov.name].dtype == np.float32
        assert arrays[aov.name].flags.owndata
    # The quad fills the middle of the picture, 5 units away.
    assert arrays["Alpha"][3, 4] == 1
    assert arrays["Depth"][3, 4] == pytest.approx(5)
    np.testing.assert_allclose(arrays["Normal"][3, 4], [0, 0, 1], atol=1e-6)
    assert arrays["Color"][3, 4].min() > 0
    assert arrays["SampleCount"][3, 4] == 2


def test_row_0_is_on_top(build: StageBuilder) -> None:
    quad = build.lit_quad().stage.GetPrimAtPath("/Quad")
    quad.GetAttribute("points").Set([(0, 0.5, 0), (1, 0.5, 0), (1, 3, 0), (0, 3, 0)])
    session = _core.RenderSession(build.read().scene, settings(aovs=[_core.Aov.Alpha]))
    session.start()
    session.wait()
    alpha = session.snapshot().array(_core.Aov.Alpha)
    assert alpha[0, 4] == 1
    assert alpha[-1, 4] == 0


def test_absent_aov(scene: _core.SceneDescription) -> None:
    session = _core.RenderSession(scene, settings())
    with pytest.raises(KeyError, match="depth"):
        session.snapshot().array(_core.Aov.Depth)


def test_pick(build: StageBuilder) -> None:
    quad = build.lit_quad().stage.GetPrimAtPath("/Quad")
    quad.GetAttribute("points").Set([(0, 0.5, 0), (1, 0.5, 0), (1, 3, 0), (0, 3, 0)])
    session = _core.RenderSession(build.read().scene, settings())
    found = session.pick(4.5, 0.5)
    assert found is not None
    assert (found.shape, found.instance) == (0, -1)
    assert found.triangle in (0, 1)
    assert session.pick(4.5, 5.5) is None


# ---------------------------------------------------------------------------------------- sessions


def test_progress_reaches_python(scene: _core.SceneDescription) -> None:
    seen: list[tuple[int, int, bool]] = []
    session = _core.RenderSession(
        scene, settings(), lambda p: seen.append((p.passes_done, p.passes_total, p.finished))
    )
    session.start()
    session.wait()
    assert seen[-1] == (2, 2, True)
    assert session.progress.finished
    assert session.progress.fraction == 1


def test_exception_in_the_callback(scene: _core.SceneDescription) -> None:
    def fail(_: _core.RenderProgress) -> None:
        raise LookupError("not my day")

    session = _core.RenderSession(scene, endless(), fail)
    session.start()
    with pytest.raises(LookupError, match="not my day"):
        session.wait()
    session.wait()  # it is raised once


def test_python_runs_while_waiting(scene: _core.SceneDescription) -> None:
    session = _core.RenderSession(scene, endless())
    session.start()
    waiting = threading.Thread(target=session.wait)
    waiting.start()
    # This thread can go on only if wait() has let go of the GIL.
    time.sleep(0.05)
    assert waiting.is_alive()
    session.cancel()
    waiting.join(10)
    assert not waiting.is_alive()


def test_cancel_keeps_what_there_is(scene: _core.SceneDescription) -> None:
    session = _core.RenderSession(scene, endless())
    session.start()
    while session.progress.passes_done < 1:
        time.sleep(0.001)
    session.cancel()
    assert session.wait_for(10)
    image = session.snapshot()
    assert image.statistics.passes >= 1
    assert image.array(_core.Aov.Color).any()


def test_dropping_a_running_session(scene: _core.SceneDescription) -> None:
    """The render thread may be waiting for the GIL to report; the destructor must not hold it."""
    reports: list[_core.RenderProgress] = []
    for _ in range(20):
        session = _core.RenderSession(scene, endless(), reports.append)
        session.start()
        time.sleep(0.002)
        del session
    assert gc.collect() >= 0


def test_two_sessions_at_once(scene: _core.SceneDescription) -> None:
    alone = _core.RenderSession(scene, settings(seed=1))
    alone.start()
    alone.wait()
    pair = [_core.RenderSession(scene, settings(seed=seed)) for seed in (1, 2)]
    for session in pair:
        session.start()
    for session in pair:
        session.wait()
    first, second = (session.snapshot().array(_core.Aov.Color) for session in pair)
    np.testing.assert_array_equal(first, alone.snapshot().array(_core.Aov.Color))
    assert (first != second).any()


def test_scene_may_go_before_the_session(build: StageBuilder) -> None:
    session = _core.RenderSession(build.lit_quad().read().scene, settings())
    gc.collect()
    session.start()
    session.wait()
    assert session.snapshot().array(_core.Aov.Color).any()


# ----------------------------------------------------------------------------------------- display


def test_display_keeps_the_shape() -> None:
    config = _core.ColorConfig()
    assert config.default_display in config.displays
    assert config.default_view(config.default_display) in config.views(config.default_display)
    rgb = np.full((2, 4, 3), 0.18, np.float32)
    shown = config.apply(rgb)
    assert shown.shape == rgb.shape
    assert (rgb == np.float32(0.18)).all()
    assert (shown > rgb).all()
    with pytest.raises(ValueError, match="3"):
        config.apply(np.zeros((2, 4), np.float32))
    with pytest.raises(etendue.SettingsError):
        config.apply(rgb, "no such display")
