"""The command line: etendue render, inspect, compare, validate, tradeoff."""

from __future__ import annotations

import json
import os
import sys
from math import isfinite
from typing import Annotated

import numpy as np
import typer
from rich.console import Console

import etendue
from etendue import _core
from etendue.arguments import FrameOption, StageArgument, numbers, open_named
from etendue.comparison import write_page
from etendue.comparison.causes import INDICES
from etendue.comparison.figures import comparison_table
from etendue.exit_status import DIFFERENT, INTERRUPTED
from etendue.image import Image
from etendue.inspection_table import inspection_table
from etendue.presets import PRESETS
from etendue.progress import duration, error_text, progress_display
from etendue.settings import (
    AOVS,
    DEFAULT_SAMPLES,
    FILTERS,
    INTEGRATORS,
    RenderOptions,
    integrator_text,
)
from etendue.tradeoff.command import tradeoff_command
from etendue.validation.command import validate_command

CORE_DEFAULTS = _core.RenderSettings()

app = typer.Typer(
    name="etendue",
    help="A bidirectional path tracer for USD.",
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
)


def main(arguments: list[str] | None = None) -> None:
    """The console script. Ends the process with 0, 1 (error), 2 (usage), 3 (pictures
    differ, a prediction fails) or 130 (interrupted)."""
    sys.exit(run(sys.argv[1:] if arguments is None else arguments))


def run(arguments: list[str]) -> int:
    """The exit status. Errors are one line on stderr, without a traceback unless --debug."""
    debug = "--debug" in arguments
    try:
        status = app(args=arguments, prog_name="etendue", standalone_mode=False)
    except etendue.Error as error:
        if debug:
            raise
        return _fail(str(error), 1)
    except (KeyboardInterrupt, typer.Abort):
        print("etendue: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # Whoever read our output has had enough; nothing is left to be flushed at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except Exception as error:
        if debug:
            raise
        # Usage errors know how to say what is wrong.
        message = getattr(error, "format_message", None)
        if message is not None:
            # Without any argument the help has been printed, and there is no more to say.
            return _fail(f"{message()} (see etendue --help)", 2) if message() else 2
        return _fail(f"{type(error).__name__}: {error}", 1)
    return status if isinstance(status, int) else 0


def _fail(message: str, status: int) -> int:
    print(f"etendue: error: {' '.join(message.split())}", file=sys.stderr)
    return status


def _show_version(wanted: bool) -> None:
    if wanted:
        print(f"etendue {etendue.__version__}")
        raise typer.Exit


@app.callback()
def common(
    version: Annotated[
        bool, typer.Option("--version", callback=_show_version, is_eager=True, help="Say which.")
    ] = False,
    debug: Annotated[
        bool, typer.Option("--debug", help="Tracebacks instead of one-line errors.")
    ] = False,
) -> None:
    """A bidirectional path tracer for USD."""
    del version, debug  # looked at before the command runs


@app.command()
def render(
    stage: StageArgument,
    output: Annotated[
        str,
        typer.Option(
            "--output",
            "-o",
            metavar="OUT",
            help=".exr: all AOVs, scene-linear. .png, .tif, .jpg: through the display and view.",
        ),
    ],
    camera: Annotated[
        str | None, typer.Option(help="Prim path or name; default: the render settings', or first.")
    ] = None,
    frame: FrameOption = None,
    resolution: Annotated[
        str | None, typer.Option(metavar="WxH", help="Default: the render settings', or 960 wide.")
    ] = None,
    crop: Annotated[
        str | None, typer.Option(metavar="X0,Y0,X1,Y1", help="Pixels of the image, row 0 on top.")
    ] = None,
    preset: Annotated[
        str | None,
        typer.Option(
            help=f"{'|'.join(PRESETS)}: an --error, a --max-depth and a most --spp; any of them "
            "given as well replaces the preset's."
        ),
    ] = None,
    spp: Annotated[
        int | None,
        typer.Option(
            help=f"Samples per pixel; default {DEFAULT_SAMPLES}; no limit beside --time or --error."
        ),
    ] = None,
    time: Annotated[
        float | None, typer.Option(help="Seconds; whichever limit comes first ends the render.")
    ] = None,
    error: Annotated[
        float | None,
        typer.Option(
            help="Relative error that is good enough, from the picture's own noise: 0.05 for 5 %. "
            "Takes 240 bytes a pixel of memory."
        ),
    ] = None,
    adaptive: Annotated[
        bool, typer.Option("--adaptive", help="Samples go where the noise is (path, bdpt).")
    ] = False,
    integrator: Annotated[
        str,
        typer.Option(
            help=f"{'|'.join(INTEGRATORS)}; auto chooses path or bdpt, and --light-paths, by a "
            "short trial of each."
        ),
    ] = "bdpt",
    max_depth: Annotated[
        int | None,
        typer.Option(
            help=f"Bounces; 0 shows emission only; default {CORE_DEFAULTS.max_depth}, "
            "or the preset's."
        ),
    ] = None,
    seed: Annotated[int, typer.Option(help="The same seed gives the same image.")] = 0,
    threads: Annotated[int, typer.Option(help="0: all.")] = 0,
    texture_memory: Annotated[
        float | None,
        typer.Option(
            metavar="MB",
            help="Texels that are kept decoded; default "
            f"{CORE_DEFAULTS.texture_memory:g}. Others are read again when they are needed.",
        ),
    ] = None,
    light_paths: Annotated[
        float | None,
        typer.Option(
            help="Light subpaths per pixel and pass (bdpt, light); default: as many as pay."
        ),
    ] = None,
    pixel_filter: Annotated[str, typer.Option("--filter", help="|".join(FILTERS))] = "box",
    ocio: Annotated[
        str, typer.Option(metavar="FILE", help="OpenColorIO config; default: $OCIO, else our own.")
    ] = "",
    display: Annotated[str, typer.Option(help="OpenColorIO display; default: the config's.")] = "",
    view: Annotated[str, typer.Option(help="OpenColorIO view; default: the display's.")] = "",
    bits: Annotated[int, typer.Option(help="8 or 16, for display images.")] = 8,
    aov: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME", help=f"Besides color and alpha; repeatable: {'|'.join(AOVS)}"),
    ] = None,
    strategy_images: Annotated[
        int,
        typer.Option(
            metavar="K",
            help="Layers st.weighted.s2t3.R and so on in the .exr: what every strategy (s, t) "
            "makes of paths with up to K edges (s + t - 1).",
        ),
    ] = CORE_DEFAULTS.strategy_images,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No progress.")] = False,
) -> int:
    """Render a stage to a file. Ctrl-C writes what has been rendered so far."""
    # Whatever can be refused is refused before the work.
    kind = _core.image_file_kind(output)
    _core.check_writable(output)
    if kind == _core.ImageFileKind.Display:
        if strategy_images:
            raise typer.BadParameter(f"'{output}': --strategy-images are layers of an .exr")
        _check_display(output, ocio, display, view, bits)
    options = RenderOptions(
        resolution=numbers("resolution", resolution, "x", 2),
        crop=numbers("crop", crop, ",", 4),
        preset=preset,
        spp=spp,
        time=time,
        error=error,
        adaptive=adaptive,
        integrator=integrator,
        max_depth=max_depth,
        seed=seed,
        threads=threads,
        texture_memory=texture_memory,
        light_paths=light_paths,
        filter=pixel_filter,
        aovs=["alpha", *(aov or [])],
        strategy_images=strategy_images,
    )
    scene = open_named(stage, frame)
    console = Console(file=sys.stderr, highlight=False)
    interrupted = False
    try:
        image = _render(scene, camera, options, console, quiet)
    except etendue.Interrupted as interruption:
        interrupted = True
        image = interruption.image
    image.save(output, display=display, view=view, ocio=ocio, bits=bits)
    statistics = image.statistics
    told = "interrupted, wrote" if interrupted else "wrote"
    samples = f"{statistics.passes} spp" if statistics.passes else "less than 1 spp"
    if isfinite(statistics.error):
        # Of a black picture 0 % would be said, which nobody knows.
        samples += f", {error_text(statistics.error) if image.color.any() else 'nothing seen'}"
    if statistics.chosen is not None:
        samples += f", auto chose {integrator_text(statistics.chosen)}"
    if interrupted or not quiet:
        _say(
            f"{told} {output}: {image.width}x{image.height}, {samples}, "
            f"{duration(statistics.seconds)}"
        )
    refused = sum(statistics.invalid.values())
    if refused:
        counts = ", ".join(f"{count} {name}" for name, count in statistics.invalid.items())
        _say(f"etendue: warning: {refused} contributions were refused ({counts})")
    return INTERRUPTED if interrupted else 0


@app.command()
def inspect(
    stage: StageArgument,
    frame: FrameOption = None,
    as_json: Annotated[bool, typer.Option("--json", help="For programs.")] = False,
) -> None:
    """Tell what a stage holds and what a render of it needs."""
    inspection = open_named(stage, frame, quiet=True).inspect()
    if as_json:
        print(json.dumps(inspection.to_dict(), indent=2))
    else:
        Console().print(inspection_table(inspection))


@app.command()
def compare(
    a: Annotated[str, typer.Argument(metavar="A.exr", help="What B is measured by.")],
    b: Annotated[str, typer.Argument(metavar="B.exr", help="Of the same scene and size.")],
    reference: Annotated[
        str | None,
        typer.Option(metavar="R.exr", help="What both should be; also tells where it is bright."),
    ] = None,
    layer: Annotated[
        str | None,
        typer.Option(help="Of all files: Beauty for Beauty.R; default: the obvious one."),
    ] = None,
    ior: Annotated[
        list[float] | None,
        typer.Option(
            metavar="N", help="Index of refraction in the scene; repeatable. Default: the usual."
        ),
    ] = None,
    flip: Annotated[
        bool | None, typer.Option("--flip/--no-flip", help="Default: up to 4 megapixels.")
    ] = None,
    html: Annotated[
        str | None, typer.Option(metavar="OUT.html", help="Also write a page with the pictures.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="For programs.")] = False,
    tolerance: Annotated[
        float | None,
        typer.Option(
            min=0,
            metavar="T",
            help=f"End with status {DIFFERENT} when B / A, over the whole picture or where it is "
            "brightest, surely differs from 1 by more.",
        ),
    ] = None,
) -> int:
    """Tell by how much, and where, two pictures by any renderers differ in brightness."""
    if html is not None:
        _core.check_writable(html)
    found = etendue.compare(a, b, reference, layer=layer, indices=ior or INDICES, flip=flip)
    if html is not None:
        write_page(found, html)
    if as_json:
        print(json.dumps(found.to_dict(), indent=2, allow_nan=False))
    else:
        console = Console(highlight=False)
        console.print(comparison_table(found))
        console.print(found.sentence, markup=False)
    return DIFFERENT if tolerance is not None and found.differs(tolerance) else 0


app.command("validate")(validate_command)
app.command("tradeoff")(tradeoff_command)


def _render(
    stage: etendue.Stage,
    camera: str | None,
    options: RenderOptions,
    console: Console,
    quiet: bool,
) -> Image:
    session = stage.session(camera, last=True, **options)
    if quiet:
        return session.run()
    with progress_display(console, session.pixels) as show:
        return session.run(show)


def _check_display(output: str, ocio: str, display: str, view: str, bits: int) -> None:
    """Raises what saving would raise, before the render."""
    if bits not in (8, 16):
        raise typer.BadParameter("--bits is 8 or 16")
    if bits == 16 and output.lower().endswith((".jpg", ".jpeg")):
        raise typer.BadParameter(f"'{output}': jpeg holds 8 bits only")
    _core.ColorConfig(ocio).apply(np.zeros((1, 3), np.float32), display, view)


def _say(line: str) -> None:
    print(line, file=sys.stderr)


if __name__ == "__main__":
    main()
