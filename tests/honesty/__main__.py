"""Whether renders are as good as they claim to be: `python tests/honesty`.

Renders stages with `--error` targets and many seeds, and holds the relMSE that each claims against
the one it has, by a long reference. Then renders them with every preset, and measures what each
takes and gives; and what it gains to place samples where the noise is. With --write the tables go
into README.md beside this file.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from honesty import gain, presets
from honesty.cases import BAR, CASES, Case
from honesty.claims import Claims, Reference, claims, open_stage, percent, reference
from support.machine import machine
from support.marked_table import Row, replace_between_markers, table

HERE = Path(__file__).resolve().parent
SEEDS = 30
HEAD = (
    "stage",
    "integrator",
    "target",
    "spp",
    "claimed",
    "actual",
    "reference's error",
    "mean actual / claimed relMSE",
    "least",
    "largest",
    "brightness",
)


def row(case: Case, target: float, found: Claims, against: Reference) -> Row:
    ratios = found.ratios
    mean = f"{ratios.mean():.2f} ± {ratios.std(ddof=1) / np.sqrt(len(ratios)):.2f}"
    return [
        case.stage,
        case.integrator,
        percent(target),
        f"{found.spp.min():.0f}-{found.spp.max():.0f}",
        percent(np.sqrt(found.claimed.mean())),
        percent(np.sqrt(found.actual.mean())),
        percent(against.error) + ("" if against.error <= case.reference_error else " (missed)"),
        f"**{mean}**" if BAR[0] <= ratios.mean() <= BAR[1] else f"{mean} (missed)",
        f"{ratios.min():.2f}",
        f"{ratios.max():.2f}",
        f"{found.brightness.mean():.4f} ± {found.brightness_error(against):.4f}",
    ]


def rows(cases: list[Case], seeds: int) -> Iterator[Row]:
    for case in cases:
        stage = open_stage(case.stage)
        against = reference(stage, case.reference_options())
        for target in case.targets:
            found = claims(stage, against, case.options(target), range(seeds))
            cells = row(case, target, found, against)
            print(" | ".join(cells), f"{found.cpu.sum():.1f} CPU s", file=sys.stderr, flush=True)
            yield cells


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("stages", nargs="*", help="names; default all")
    parser.add_argument("--seeds", type=int, default=SEEDS, help="of the claims' table")
    parser.add_argument(
        "--table", choices=("claims", "dial", "presets", "adaptive"), help="one of them"
    )
    parser.add_argument("--write", action="store_true", help="put the table into README.md")
    args = parser.parse_args()
    if args.write and (args.stages or args.seeds != SEEDS):
        parser.error("--write takes neither stages nor seeds: a table is of all, measured alike")
    cases = [case for case in CASES if not args.stages or case.stage in args.stages]
    tables = {
        "claims": (HEAD, rows(cases, args.seeds)),
        "dial": (presets.DIAL_HEAD, presets.dial()),
        "presets": (presets.HEAD, presets.rows([case.stage for case in cases])),
        "adaptive": (gain.HEAD, gain.rows(args.stages or list(gain.STAGES))),
    }
    for name in [args.table] if args.table else tables:
        head, found = tables[name]
        text = f"{machine()}.\n\n{table(head, found)}" if name != "dial" else table(head, found)
        print(text)
        if args.write:
            replace_between_markers(HERE / "README.md", name, text)


if __name__ == "__main__":
    main()
