"""Settings that come with the stage."""

from __future__ import annotations

from pathlib import Path

from pxr import Sdf

from support.hydra_host import HydraHost
from support.hydra_studio import ENVIRONMENTS, Studio, exported, recorded, reference
from support.same_picture import assert_same_picture

Types = Sdf.ValueTypeNames


@ENVIRONMENTS
def test_the_active_render_settings_are_heeded(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    studio.box("/Box")
    settings = studio.render_settings().GetPrim()
    for name, kind, value in (
        ("samplesPerPixel", Types.Int, 2),
        ("seed", Types.Int, 5),
        ("maxDepth", Types.Int, 1),
        ("integrator", Types.String, "path"),
    ):
        settings.CreateAttribute(f"etendue:{name}", kind).Set(value)
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
    settings = studio.render_settings().GetPrim()
    # Looked at for the first time after 16 passes, and met by then.
    for name, kind, value in (
        ("samplesPerPixel", Types.Int, 40),
        ("errorTarget", Types.Float, 10.0),
    ):
        settings.CreateAttribute(f"etendue:{name}", kind).Set(value)
    file = exported(studio, tmp_path)
    ours, _ = recorded(host, file, environment)
    assert_same_picture(ours, reference(file, ours, spp=16))


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
