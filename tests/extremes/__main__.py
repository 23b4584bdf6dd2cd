"""Runs the suite of numerical extremes and shows what it measured: `./etendue test extremes`.

The C++ program extremes_test checks each figure against its limit and records both as a property of
the test, which GoogleTest writes down as JSON. With --write they become the table of README.md
beside this file; only a run in which everything held may do that.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from support.marked_table import Row, replace_between_markers, table

README = Path(__file__).resolve().parent / "README.md"
HEAD = ("extreme", "what must hold", "measured", "limit")


def run(program: Path, arguments: list[str], results: Path) -> int:
    """The program's exit code; 0 when everything held."""
    command = [str(program), "--gtest_brief=1", f"--gtest_output=json:{results}", *arguments]
    return subprocess.run(command, check=False).returncode


def recorded_rows(results: Path) -> Iterator[Row]:
    """Family, extreme, what must hold, measured, limit; in the order of the tests."""
    for suite in json.loads(results.read_text(encoding="utf-8"))["testsuites"]:
        for test in suite["testsuite"]:
            for key, value in test.items():
                if key.startswith("row_"):
                    yield value.split("|")


def tables(rows: list[Row]) -> str:
    """One table with a heading for each family."""
    families = list(dict.fromkeys(row[0] for row in rows))
    parts = []
    for family in families:
        of_family = [row[1:] for row in rows if row[0] == family]
        parts.append(f"### {family[0].upper()}{family[1:]}\n\n{table(HEAD, of_family)}")
    return "\n\n".join(parts)


def main() -> int:
    """Returns 1 unless everything holds."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=Path, help="extremes_test, as built")
    parser.add_argument("--write", action="store_true", help="put the table into README.md")
    parser.add_argument("--filter", default="*", help="which tests, as GoogleTest's --gtest_filter")
    arguments = parser.parse_args()
    if arguments.write and arguments.filter != "*":
        parser.error("--write wants all tests")
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "results.json"
        status = run(arguments.program, [f"--gtest_filter={arguments.filter}"], results)
        if not results.exists():
            print(f"{arguments.program} did not finish", file=sys.stderr)
            return 1
        text = tables(list(recorded_rows(results)))
    print(text)
    if arguments.write and status == 0:
        replace_between_markers(README, "extremes", text)
    return 0 if status == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
