"""That only what a scene requires costs anything: `python tests/bench/only_required.py`.

Instructions per path and peak memory of a plain diffuse scene, with the core as it is and with one
from which unused features are compiled out (plain/CMakeLists.txt); and where time and memory go
between opening a stage of a million triangles and its first pixels. With --write the tables go into
README.md beside this file.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from pxr import Usd, UsdGeom, UsdLux, Vt

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from support.machine import machine
from support.marked_table import replace_between_markers, table

HERE = Path(__file__).resolve().parent
MILLION = 707  # quads along a side, of two triangles each
MIB = 2**20

Result = dict[str, Any]


# --------------------------------------------------------------------------------- compiled out


def instructions(program: Path, samples: int) -> tuple[int, int]:
    """Within the integrator, and the number of paths that took them."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            "valgrind",
            "--tool=callgrind",
            f"--callgrind-out-file={folder}/out",
            "--toggle-collect=etendue::PathIntegrator::render*",
            str(program),
            str(samples),
        ]
        done = subprocess.run(command, check=True, capture_output=True, text=True)
    collected = re.search(r"Collected : (\d+)", done.stderr)
    assert collected
    return int(collected[1]), int(json.loads(done.stdout)["paths"])


def plain_rows(folder: Path) -> list[list[str]]:
    rows = []
    for name, what in (("full", "the core as it is"), ("bare", "unused features compiled out")):
        program = folder / f"plain_{name}"
        count, paths = instructions(program, 4)
        run = subprocess.run([program, "8"], check=True, capture_output=True, text=True)
        told = json.loads(run.stdout)
        own, libraries = told["peak"] - told["libraries"], told["libraries"]
        rows.append([what, f"{count / paths:,.0f}", f"{own / 1024:.1f}", f"{libraries / 1024:.0f}"])
    return rows


# ---------------------------------------------------------------------------- a million triangles


def write_ground(file: Path, side: int) -> None:
    """A waved ground of 2 side^2 triangles, a camera and a lamp."""
    stage = Usd.Stage.CreateNew(str(file))
    mesh = UsdGeom.Mesh.Define(stage, "/Ground")
    x, y = np.meshgrid(np.linspace(-1, 1, side + 1), np.linspace(-1, 1, side + 1))
    points = np.stack([x, y, 0.1 * np.sin(9 * x) * np.cos(7 * y)], axis=-1).reshape(-1, 3)
    a = (np.arange(side) + (side + 1) * np.arange(side)[:, np.newaxis]).ravel()
    corners = np.stack([a, a + 1, a + side + 2, a, a + side + 2, a + side + 1], axis=-1).ravel()
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points.astype(np.float32)))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(2 * side**2, 3, np.int32)))
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(corners.astype(np.int32)))
    mesh.CreateSubdivisionSchemeAttr("none")
    UsdGeom.Camera.Define(stage, "/Camera").AddTranslateOp().Set((0, 0, 5))
    light = UsdLux.SphereLight.Define(stage, "/Light")
    light.AddTranslateOp().Set((0, 0, 8))
    light.CreateIntensityAttr(50.0)
    stage.Save()


def first_pixels(file: Path) -> Result:
    """What first_pixels.py says, in a process of its own."""
    command = [sys.executable, str(HERE / "first_pixels.py"), str(file)]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    result: Result = json.loads(done.stdout.splitlines()[-1])
    return result


def embree_seconds(file: Path) -> float:
    """CPU seconds in Embree, by perf's share of the samples; NaN where perf is missing or refused.
    Work of the kernel (fresh pages) counts for nobody."""
    from bench.embree_share import recording

    with tempfile.TemporaryDirectory() as folder:
        data = Path(folder) / "perf.data"
        prefix = recording(data)
        if not prefix:
            return float("nan")
        command = [*prefix, sys.executable, str(HERE / "first_pixels.py"), str(file)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        report = subprocess.run(
            ["perf", "report", f"--input={data}", "--sort=dso", "--stdio", "--field-separator=;"],
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        samples = subprocess.run(
            ["perf", "script", f"--input={data}", "--fields=event"],
            check=True,
            capture_output=True,
            text=True,
        ).stdout.count("cpu-clock")
    share = sum(float(x) for x in re.findall(r"([0-9.]+)%?\s*;\s*libembree", report))
    return share / 100 * samples / 500


def million_rows() -> tuple[list[list[str]], list[list[str]]]:
    with tempfile.TemporaryDirectory() as folder:
        large, small = Path(folder) / "large.usdc", Path(folder) / "small.usdc"
        write_ground(large, MILLION)
        write_ground(small, 7)
        runs = [first_pixels(large) for _ in range(3)]
        least = {part: min(run["seconds"][part] for run in runs) for part in runs[0]["seconds"]}
        embree = embree_seconds(large)
        baseline = min(first_pixels(small)["peak"] for _ in range(3))
        peak = max(run["peak"] for run in runs)
    times = [[part, f"{seconds:.2f}"] for part, seconds in least.items()]
    times.append(["of all that, in Embree's library", f"{embree:.2f}"])
    held = runs[0]["memory"]
    parts = held["vertices"] + held["acceleration"] + held["film"]
    memory = [
        ["vertex data", f"{held['vertices'] / MIB:.1f}"],
        ["BVH", f"{held['acceleration'] / MIB:.1f}"],
        ["film", f"{held['film'] / MIB:.1f}"],
        ["sum of these", f"{parts / MIB:.1f}"],
        ["peak, less the peak of the same with 98 triangles", f"{(peak - baseline) / MIB:.1f}"],
        ["ratio", f"**{(peak - baseline) / parts:.2f}**"],
    ]
    return times, memory


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path, help="where CMake has built plain_full and plain_bare")
    parser.add_argument("--write", action="store_true", help="put the tables into README.md")
    args = parser.parse_args()
    folder = args.build / "tests" / "bench" / "plain"
    head = ("core", "instructions per path", "peak MiB beside libraries", "libraries MiB")
    texts = {"plain": f"{machine()}.\n\n{table(head, plain_rows(folder))}"}
    times, memory = million_rows()
    times_text = table(("part", "CPU s"), times)
    memory_text = table(("memory", "MiB"), memory)
    texts["million"] = f"{machine()}, one thread.\n\n{times_text}\n\n{memory_text}"
    for name, text in texts.items():
        print(text, end="\n\n")
        if args.write:
            replace_between_markers(HERE / "README.md", name, text)


if __name__ == "__main__":
    main()
