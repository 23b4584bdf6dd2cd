"""Settings that come with the stage."""

from __future__ import annotations

from pathlib import Path

import pytest
from pxr import Sdf

from support.hydra_host import HydraHost
from support.hydra_studio import ENVIRONMENTS, Studio, exported, recorded, reference
from support.same_picture import assert_same_picture

Types = Sdf.ValueTypeNames


def set_up(studio: Studio, **values: float | str) -> None:
    """Settings on the active prim."""
    kinds = {int: Types.Int, float: Types.Float, str: Types.String}
    settings = studio.render_settings().GetPrim()
    for name, value in values.items():
        settings.CreateAttribute(f"etendue:{name}", kinds[type(value)]).Set(value)


@ENVIRONMENTS
def test_the_active_render_settings_are_heeded(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    studio.box("/Box")
    set_up(studio, samplesPerPixel=2, seed=5, maxDepth=1, integrator="path", textureMemory=8.0)
    file = exported(studio, tmp_path)
    ours, _ = recorded(host, file, environment)
    expected = reference(file, ours, spp=2, seed=5, max_depth=1, integrator="path")
    assert_same_picture(ours, expected)


@ENVIRONMENTS
def test_an_error_target_ends_a_render(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    studio.box("/Box")
    # Looked at for the first time after 16 passes, and met by then.
    set_up(studio, samplesPerPixel=40, errorTarget=10.0)
    file = exported(studio, tmp_path)
    ours, _ = recorded(host, file, environment)
    assert_same_picture(ours, reference(file, ours, spp=16))


@ENVIRONMENTS
def test_texture_memory_reaches_the_session(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    studio.box("/Box")
    set_up(studio, textureMemory=-1.0)
    with pytest.raises(pytest.fail.Exception, match="the texture memory must be positive"):
        recorded(host, exported(studio, tmp_path), environment)


@ENVIRONMENTS
def test_other_render_settings_are_not(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    other = studio.render_settings().GetPrim()
    other.CreateAttribute("etendue:seed", Types.Int).Set(5)
    studio.stage.ClearMetadata("renderSettingsPrimPath")
    file = exported(studio, tmp_path)
    ours, _ = recorded(host, file, environment)
    assert_same_picture(ours, reference(file, ours))
