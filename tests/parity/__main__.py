"""python -m parity: see README.md."""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

from parity import closed_form, correctness, report, speed
from parity.cases import CASES, SKY
from parity.races import RACES
from parity.sky import write_sky

ROOT = Path(__file__).parents[2]
WORK = ROOT / "build" / "parity"
PARITY_TABLE = ROOT / "tests" / "parity" / "README.md"
SPEED_TABLE = ROOT / "tests" / "bench" / "README.md"


def main() -> int:
    """Returns 1 unless all renderers agree."""
    arguments = _arguments()
    if arguments.speed:
        run_speed(arguments.only, arguments.effort)
        return 0
    if arguments.closed_form:
        report.replace(PARITY_TABLE, "closed form", closed_form.results_table(WORK))
        return 0
    return run_correctness(arguments.only, arguments.effort, arguments.pictures)


def run_correctness(only: str, effort: float, pictures: Path | None) -> int:
    """Compares pictures and writes the table."""
    results = report.Results(WORK / "correctness.json")
    write_sky(SKY)
    disagreements = 0
    for case in (case for case in CASES if only in case.name):
        started = time.perf_counter()
        for peer, comparison in correctness.check(case, effort, pictures):
            row = correctness.row(case, peer, comparison)
            print(" | ".join(row), flush=True)
            results.put(correctness.key(case, peer), row)
            disagreements += comparison.verdict != "agrees"
        print(f"  {time.perf_counter() - started:.0f} s", flush=True)
        report.replace(PARITY_TABLE, "parity", correctness.results_table(results))
    return 1 if disagreements else 0


def run_speed(only: str, effort: float) -> None:
    """Races and writes the table."""
    results = report.Results(WORK / "speed.json")
    for race in (race for race in RACES if only in race.name):
        rows = speed.rows(race, speed.run(race, effort))
        print("\n".join(" | ".join(row) for row in rows), flush=True)
        results.put(race.name, rows)
        text = f"{report.machine()}, two threads.\n\n{speed.results_table(results)}"
        report.replace(SPEED_TABLE, "speed", text)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="./etendue test parity", description="Compares Etendue with Mitsuba 3 and LuxCore."
    )
    parser.add_argument("--speed", action="store_true", help="efficiency instead of agreement")
    parser.add_argument("--only", metavar="NAME", default="", help="rows whose name contains it")
    parser.add_argument(
        "--closed-form", action="store_true", help="who is right where others disagree"
    )
    parser.add_argument(
        "--effort", metavar="X", type=float, default=1.0, help="multiplies the samples (default 1)"
    )
    parser.add_argument("--pictures", metavar="DIR", type=Path, help="keeps mean images as .npy")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
