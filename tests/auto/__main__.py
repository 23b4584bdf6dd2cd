"""Whether `--integrator auto` chooses well: `python tests/auto`.

Renders every stage with each fixed method, asks auto what it chooses, and holds the cost of the
choice, its pilot included, against the best. With --write the table goes into README.md beside
this file.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from auto.cases import BAR, FIXED, VIEWS, View
from auto.measure import Choice, Costs, choices, costs
from support.machine import machine
from support.marked_table import Row, replace_between_markers, table

HERE = Path(__file__).resolve().parent
SEEDS = range(3)
#: Of relMSE x seconds: less is what rounding leaves.
NO_NOISE = 1e-12
SHOWN = tuple(candidate.name for candidate in FIXED)
HEAD = (
    "stage",
    "auto chooses",
    "pilot, CPU s",
    "best fixed",
    "auto / best",
    *(name.removeprefix("bdpt-").replace("light-paths-", "") for name in SHOWN),
)


def row(view: View, found: dict[str, Costs], chosen: list[Choice]) -> Row:
    best = min((name for name in SHOWN if found[name].complete), key=lambda name: found[name].mean)
    least = found[best].mean
    auto = float(np.mean([found[choice.candidate].mean * choice.overhead for choice in chosen]))
    names = dict.fromkeys(choice.candidate for choice in chosen)
    return [
        view.name,
        ", ".join(names),
        f"{np.mean([choice.pilot_seconds for choice in chosen]):.2f}",
        best,
        _held(auto, least),
        *(_ratio(found[name], least) for name in SHOWN),
    ]


def rows(views: list[View]) -> Iterator[Row]:
    for view in views:
        cells = row(view, costs(view, SEEDS), choices(view, SEEDS))
        print(" | ".join(cells), file=sys.stderr, flush=True)
        yield cells


def _held(auto: float, least: float) -> str:
    if least < NO_NOISE:
        return "**no noise**" if auto < NO_NOISE else "missed"
    ratio = auto / least
    return f"**{ratio:.2f}**" if ratio <= BAR else f"{ratio:.2f} (missed)"


def _ratio(costs: Costs, least: float) -> str:
    if not costs.complete:
        return "dark"
    if least < NO_NOISE:
        return "no noise" if costs.mean < NO_NOISE else "noise"
    return f"{costs.mean / least:.3g}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("stages", nargs="*", help="names; default all")
    parser.add_argument("--write", action="store_true", help="put the table into README.md")
    args = parser.parse_args()
    if args.write and args.stages:
        parser.error("--write takes no stages: the table is of all")
    views = [view for view in VIEWS if not args.stages or view.stage in args.stages]
    text = f"{machine()}.\n\n{table(HEAD, rows(views))}"
    print(text)
    if args.write:
        replace_between_markers(HERE / "README.md", "auto", text)


if __name__ == "__main__":
    main()
