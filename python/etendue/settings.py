"""Render options as people write them, to the core's RenderSettings."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from typing import TypedDict, TypeVar, cast

from etendue import _core
from etendue.presets import PRESETS
from etendue.usd_reader import StageContents

DEFAULT_SAMPLES = 64
DEFAULT_WIDTH = 960

INTEGRATORS = {
    "path": _core.IntegratorKind.Path,
    "light": _core.IntegratorKind.Light,
    "bdpt": _core.IntegratorKind.Bdpt,
    "auto": _core.IntegratorKind.Auto,
}
HEURISTICS = {"balance": _core.MisHeuristic.Balance, "power": _core.MisHeuristic.Power}
FILTERS = {
    "box": (_core.FilterKind.Box, 0.5),
    "triangle": (_core.FilterKind.Triangle, 1.0),
    "gaussian": (_core.FilterKind.Gaussian, 1.5),
}
AOVS = {_core.aov_name(aov): aov for aov in _core.Aov.__members__.values()}
STRATEGIES = ("emission_hit", "direct_light", "connection", "light_image", "lens_hit")
ADJOINT = ("refraction", "shading_normal", "phong")

_T = TypeVar("_T")


class RenderOptions(TypedDict, total=False):
    """Keywords of Stage.render() and Stage.session().

    resolution: (width, height) in pixels; default: the stage's RenderSettings, else 960 wide with
        the camera's aspect.
    crop: (x0, y0, x1, y1), pixels [x0, x1) x [y0, y1) of the full image, row 0 on top.
    preset: "draft", "preview", "final" or "reference": an error, a max_depth and a most spp, as
        PRESETS has them; any of the three that is given as well replaces the preset's.
    spp: samples per pixel; default 64, or no limit when `time` or `error` is given. 0: no limit.
    time: seconds; the render ends at whichever limit comes first.
    error: relative error of the picture that is good enough, 0.05 for 5 %: the root of relMSE, as
        RenderStatistics.error estimates it from the picture's own noise. It is looked at now and
        then from the 16th sample on, and takes 240 bytes a pixel of memory. What a finite
        max_depth leaves out, and what is too rare for any sample so far, is no noise and not in it.
    adaptive: places the samples of path and bdpt where the noise is, tile by tile, from the 17th
        per pixel on; without bias. Default False. light has none to place and stays as it is.
    integrator: "path", "light", "bdpt" (default) or "auto", which chooses path, or bdpt with a
        number of light paths, by what the stage holds and, for renders long enough to pay for it,
        by a small trial of each. RenderStatistics.chosen tells; see integrator_text().
    max_depth: bounces; 0 shows emission only. Default 16.
    seed: the same seed gives the same image, whatever the number of threads.
    threads: 0 (default) means all.
    texture_memory: megabytes of texels that are kept decoded, default 1024; more are read again
        when they are needed. An image without tiles (png, jpeg) is one piece, and each thread holds
        up to eight pieces whatever the limit.
    aovs: names of AOVS; default color and alpha. Color is always there.
    strategy_images: keeps the image of every strategy (s, t), weighted (they sum up to color) and
        unweighted, of paths with up to this many edges (s + t - 1), under names like
        "st.weighted.s2t3". Default 0: none. For bdpt and light.
    filter: "box" (default), "triangle" or "gaussian"; filter_radius in pixels.
    heuristic: "power" (default) or "balance", for the weights of path and bdpt.
    strategies: the names of STRATEGIES that take part; default all.
    single_strategy: (s, t), s light and t camera vertices: shows this strategy alone, unweighted.
    light_paths: light subpaths per pixel and pass. Default: 1 for light; for bdpt 4 where something
        gathers light into caustics, which they alone render well, else 0.5.
    roulette_depth: bounces before Russian roulette; negative: never.
    adjoint: the names of ADJOINT corrections that are made; default all. Leaving one out is
        wrong on purpose, for validation.
    """

    resolution: tuple[int, int] | None
    crop: tuple[int, int, int, int] | None
    preset: str | None
    spp: int | None
    time: float | None
    error: float | None
    integrator: str
    adaptive: bool
    max_depth: int | None
    seed: int
    threads: int
    texture_memory: float | None
    aovs: Iterable[str]
    strategy_images: int
    filter: str
    filter_radius: float | None
    heuristic: str
    strategies: Iterable[str] | None
    single_strategy: tuple[int, int] | None
    light_paths: float | None
    roulette_depth: int
    adjoint: Iterable[str] | None


def render_settings(
    contents: StageContents, camera: str | None, options: RenderOptions
) -> _core.RenderSettings:
    """The stage's settings with the options over them. Raises SettingsError and SceneError."""
    options = _with_preset(options)
    settings = _core.RenderSettings()
    settings.camera = _camera_index(contents, camera)
    settings.width, settings.height = _resolution(contents, settings.camera, options)
    settings.conform = contents.settings.conform
    settings.crop = _crop(contents, settings.width, settings.height, options.get("crop"))

    settings.integrator = _choice("integrator", options.get("integrator", "bdpt"), INTEGRATORS)
    _set_limits(settings, options)
    settings.adaptive = options.get("adaptive", settings.adaptive)
    max_depth = options.get("max_depth")
    if max_depth is not None:
        settings.max_depth = _at_least("max_depth", max_depth, 0)
    settings.seed = _at_least("seed", options.get("seed", 0), 0)
    settings.threads = _at_least("threads", options.get("threads", 0), 0)
    texture_memory = options.get("texture_memory")
    if texture_memory is not None:
        settings.texture_memory = _positive("texture_memory", texture_memory, "number of megabytes")
    settings.heuristic = _choice("heuristic", options.get("heuristic", "power"), HEURISTICS)
    settings.filter = _filter(options)
    settings.light_paths_per_pixel = options.get("light_paths")
    settings.roulette_depth = options.get("roulette_depth", settings.roulette_depth)
    settings.strategies = _core.StrategySet(
        **_switches("strategy", options.get("strategies"), STRATEGIES)
    )
    single = options.get("single_strategy")
    if single is not None:
        settings.single_strategy = _core.Strategy(s=single[0], t=single[1])
    settings.adjoint = _core.AdjointPolicy(
        **_switches("adjoint correction", options.get("adjoint"), ADJOINT)
    )
    settings.strategy_images = _at_least(
        "strategy_images", options.get("strategy_images", settings.strategy_images), 0
    )
    names = ["color", *options.get("aovs", ("alpha",))]
    settings.aovs = [_choice("aov", name, AOVS) for name in dict.fromkeys(names)]
    return settings


def integrator_text(chosen: _core.ChosenMethod) -> str:
    """What "auto" chose, as options of the command that repeat the render."""
    name = next(name for name, kind in INTEGRATORS.items() if kind == chosen.integrator)
    count = chosen.light_paths_per_pixel
    return f"--integrator {name}" + ("" if count is None else f" --light-paths {count:g}")


def _with_preset(options: RenderOptions) -> RenderOptions:
    """What is given, over the preset's."""
    name = options.get("preset")
    if name is None:
        return options
    preset = _choice("preset", name, PRESETS)
    given = {key: value for key, value in options.items() if value is not None}
    return cast(RenderOptions, asdict(preset) | given)


def _set_limits(settings: _core.RenderSettings, options: RenderOptions) -> None:
    """When the render ends."""
    settings.time_limit = _positive("time", options.get("time"), "number of seconds")
    settings.error_target = _positive("error", options.get("error"), "number, 0.05 for 5 %")
    limited = settings.time_limit > 0 or settings.error_target > 0
    samples = options.get("spp")
    if samples is None:
        samples = 0 if limited else DEFAULT_SAMPLES
    settings.samples_per_pixel = _at_least("spp", samples, 0)
    if not samples and not limited:
        raise _core.SettingsError(
            "spp, time and error are all unlimited: the render would never end"
        )


def _camera_index(contents: StageContents, camera: str | None) -> int:
    """By prim path, or by prim name when only one camera has it."""
    cameras = contents.cameras
    known = ", ".join(cameras) or "none"
    wanted = camera or contents.settings.camera
    if wanted is None:
        if cameras:
            return 0
        raise _core.SceneError(f"{contents.source}: the stage has no camera")
    if wanted in cameras:
        return cameras.index(wanted)
    named = [path for path in cameras if path.rsplit("/", 1)[-1] == wanted]
    if len(named) == 1:
        return cameras.index(named[0])
    raise _core.SettingsError(
        f"{contents.source}: '{wanted}' is not a camera of the stage; cameras: {known}"
    )


def _resolution(contents: StageContents, camera: int, options: RenderOptions) -> tuple[int, int]:
    given = options.get("resolution")
    if given is not None:
        width, height = (_at_least("resolution", pixels, 1) for pixels in given)
        return width, height
    if contents.settings.resolution is not None:
        return contents.settings.resolution
    desc = contents.scene.cameras[camera]
    if desc.horizontal_aperture <= 0 or desc.vertical_aperture <= 0:
        return DEFAULT_WIDTH, DEFAULT_WIDTH
    aspect = desc.horizontal_aperture / desc.vertical_aperture
    return DEFAULT_WIDTH, max(1, round(DEFAULT_WIDTH / aspect))


def _crop(
    contents: StageContents,
    width: int,
    height: int,
    crop: Sequence[int] | None,
) -> _core.PixelWindow | None:
    if crop is not None:
        x0, y0, x1, y1 = crop
        if not (0 <= x0 < x1 <= width and 0 <= y0 < y1 <= height):
            raise _core.SettingsError(
                f"crop {x0},{y0},{x1},{y1} is empty or outside of the image of {width}x{height}"
            )
        return _core.PixelWindow(x0=x0, y0=y0, x1=x1, y1=y1)
    left, bottom, right, top = contents.settings.data_window
    if (left, bottom, right, top) == (0.0, 0.0, 1.0, 1.0):
        return None
    # dataWindowNDC counts from the bottom; a pixel is in when its centre is.
    window = _core.PixelWindow(
        x0=_first_centre(left, width),
        y0=_first_centre(1 - top, height),
        x1=_first_centre(right, width),
        y1=_first_centre(1 - bottom, height),
    )
    if window.x0 >= window.x1 or window.y0 >= window.y1:
        raise _core.SettingsError(f"{contents.settings.path}: dataWindowNDC holds no pixel")
    return window


def _first_centre(edge: float, pixels: int) -> int:
    """The first pixel whose centre is not before `edge` (0..1), within the image."""
    return min(max(math.ceil(edge * pixels - 0.5), 0), pixels)


def _filter(options: RenderOptions) -> _core.PixelFilter:
    kind, default_radius = _choice("filter", options.get("filter", "box"), FILTERS)
    radius = options.get("filter_radius")
    return _core.PixelFilter(kind=kind, radius=default_radius if radius is None else radius)


def _choice(what: str, name: str, choices: Mapping[str, _T]) -> _T:
    if name not in choices:
        raise _core.SettingsError(f"unknown {what} '{name}'; there are: {', '.join(choices)}")
    return choices[name]


def _switches(what: str, names: Iterable[str] | None, known: Sequence[str]) -> dict[str, bool]:
    on = set(known if names is None else names)
    for name in on - set(known):
        raise _core.SettingsError(f"unknown {what} '{name}'; there are: {', '.join(known)}")
    return {name: name in on for name in known}


def _at_least(what: str, value: int, minimum: int) -> int:
    if value < minimum:
        raise _core.SettingsError(f"{what} is {value}; it must be {minimum} or more")
    return value


def _positive(what: str, value: float | None, wanted: str) -> float:
    """0 for None."""
    if value is None:
        return 0.0
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not number > 0 or not math.isfinite(number):
        raise _core.SettingsError(f"{what} is {value}; it must be a positive {wanted}")
    return number
