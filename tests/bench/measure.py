"""Renders one stage with one integrator and prints what it cost and how noisy it was, as JSON.

A process of its own, so that peak memory and a profile are this render's alone.
"""

from __future__ import annotations

import argparse
import json
import resource
import time
from pathlib import Path

import numpy as np

import etendue


def measure(args: argparse.Namespace) -> dict[str, float]:
    stage = etendue.open(args.stage)
    cpu = wall = rays = paths = 0.0
    images = []
    for seed in range(args.first_seed, args.first_seed + args.seeds):
        cpu_before, wall_before = time.process_time(), time.perf_counter()
        image = stage.render(
            resolution=(args.width, args.height),
            spp=args.spp,
            integrator=args.integrator,
            seed=seed,
            threads=args.threads,
        )
        cpu += time.process_time() - cpu_before
        wall += time.perf_counter() - wall_before
        rays += image.statistics.rays
        paths += max(image.statistics.camera_paths, image.statistics.light_paths)
        images.append(image.color.astype(np.float64))
    np.save(args.out, np.array(images))
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    return {"cpu": cpu, "wall": wall, "rays": rays, "paths": paths, "peak": peak}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("stage")
    parser.add_argument("integrator")
    parser.add_argument("out", type=Path, help="where the images go, (seeds, h, w, 3), .npy")
    parser.add_argument("--width", type=int, required=True)
    parser.add_argument("--height", type=int, required=True)
    parser.add_argument("--spp", type=int, required=True)
    parser.add_argument("--seeds", type=int, required=True)
    parser.add_argument("--first-seed", type=int, required=True)
    parser.add_argument("--threads", type=int, required=True)
    print(json.dumps(measure(parser.parse_args())))


if __name__ == "__main__":
    main()
