"""How fast Etendue renders its stages, and what that buys: `python tests/bench`.

Every stage with every integrator, in turn and round after round, so that a noisy machine is noisy
for all alike. Efficiency is 1 / (relMSE x CPU seconds): twice the efficiency is the same noise in
half the time. relMSE (support/rel_mse.py) is against a long bdpt render: a variance between seeds
would flatter path tracing, which hardly ever finds a caustic and then looks noiseless.
With --write the table goes into README.md beside this file.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import numpy.typing as npt

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from bench.embree_share import embree_share, recording
from support.machine import machine
from support.marked_table import replace_between_markers, table
from support.rel_mse import rel_mse

HERE = Path(__file__).resolve().parent
STAGES = HERE.parent.parent / "stages"
INTEGRATORS = ("path", "light", "bdpt")
HEAD = (
    "stage",
    "integrator",
    "Mpaths/CPU s",
    "Mrays/CPU s",
    "in Embree",
    "peak MB",
    "efficiency (robust)",
    "cores",
)

Images = npt.NDArray[np.float64]


@dataclass
class Row:
    """What all rounds of one stage and integrator add up to."""

    stage: str
    integrator: str
    cpu: float = 0
    wall: float = 0
    rays: float = 0
    paths: float = 0
    peak: float = 0
    share: float = math.nan
    images: list[Images] = field(default_factory=list)

    def add(self, result: dict[str, float], images: Images, share: float) -> None:
        self.cpu += result["cpu"]
        self.wall += result["wall"]
        self.rays += result["rays"]
        self.paths += result["paths"]
        self.peak = max(self.peak, result["peak"])
        self.share = share
        self.images.extend(images)

    def cells(self, reference: Images) -> list[str]:
        error = rel_mse(self.images, reference)
        work = self.cpu / len(self.images)
        return [
            self.stage,
            self.integrator,
            f"{self.paths / self.cpu / 1e6:.3f}",
            f"{self.rays / self.cpu / 1e6:.2f}",
            "-" if math.isnan(self.share) else f"{self.share:.0%}",
            f"{self.peak / 2**20:.0f}",
            f"{1 / (error.whole * work):.3g} ({1 / (error.robust * work):.3g})",
            f"{self.cpu / self.wall:.2f}",
        ]


def run_once(row: Row, args: argparse.Namespace, spp: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        images, profile = Path(folder) / "images.npy", Path(folder) / "perf.data"
        command = [
            *recording(profile),
            sys.executable,
            str(HERE / "measure.py"),
            str(STAGES / f"{row.stage}.usda"),
            row.integrator,
            str(images),
            f"--width={args.width}",
            f"--height={args.height}",
            f"--spp={spp}",
            f"--seeds={args.seeds}",
            f"--first-seed={args.first_seed}",
            f"--threads={args.threads}",
        ]
        output = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
        row.add(json.loads(output.splitlines()[-1]), np.load(images), embree_share(profile))


def reference(stage: str, args: argparse.Namespace) -> Images:
    """Long enough that its own noise is a few per cent of the compared renders'."""
    row = Row(stage, "bdpt")
    run_once(
        row,
        argparse.Namespace(**{**vars(args), "seeds": 1, "first_seed": 1000}),
        args.reference_spp,
    )
    return row.images[0]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("stages", nargs="*", help="names; default all")
    parser.add_argument("--integrators", nargs="+", default=INTEGRATORS, choices=INTEGRATORS)
    parser.add_argument("--width", type=int, default=96)
    parser.add_argument("--height", type=int, default=72)
    parser.add_argument(
        "--spp", type=int, default=32, help="of path and light; bdpt takes a quarter"
    )
    parser.add_argument("--seeds", type=int, default=8)
    parser.add_argument("--reference-spp", type=int, default=1024)
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--threads", type=int, default=min(2, os.cpu_count() or 1))
    parser.add_argument("--write", action="store_true", help="put the table into README.md")
    args = parser.parse_args()
    if args.write and args != parser.parse_args(["--write"]):
        parser.error("--write takes no other option: the table is of all stages, measured alike")
    names = args.stages or sorted(path.stem for path in STAGES.glob("*.usda"))
    rows = [Row(stage, integrator) for stage in names for integrator in args.integrators]
    for done in range(args.rounds):
        for row in rows:
            print(f"round {done + 1}: {row.stage} {row.integrator}", file=sys.stderr, flush=True)
            args.first_seed = done * args.seeds
            run_once(row, args, args.spp if row.integrator != "bdpt" else max(args.spp // 4, 1))
    references = {stage: reference(stage, args) for stage in names}
    text = table(HEAD, [row.cells(references[row.stage]) for row in rows])
    text = f"{machine()}, {args.threads} threads.\n\n{text}"
    print(text)
    if args.write:
        replace_between_markers(HERE / "README.md", "stages", text)


if __name__ == "__main__":
    main()
