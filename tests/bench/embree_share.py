"""Share of a render's CPU time that is spent inside Embree, sampled by perf."""

from __future__ import annotations

import functools
import os
import re
import shutil
import subprocess
from pathlib import Path

#: What a render thread runs. Start-up (interpreter, dynamic linker) is no part of it.
RENDERING = re.compile(r"_core\.|libembree|libm\.|libc\.|libtbb|libOpenImageIO")


def recording(data: Path) -> list[str]:
    """Prefix of a command that is to be profiled; empty where perf is missing or refused."""
    return _record(data) if _allowed() else []


@functools.cache
def _allowed() -> bool:
    """Containers and kernel.perf_event_paranoid may refuse."""
    if shutil.which("perf") is None:
        return False
    probe = subprocess.run([*_record(Path(os.devnull)), "true"], check=False, capture_output=True)
    return probe.returncode == 0


def _record(data: Path) -> list[str]:
    options = ["--quiet", "--event=cpu-clock", "--freq=500", f"--output={data}"]
    return ["perf", "record", *options, "--"]


def embree_share(data: Path) -> float:
    """NaN without a profile."""
    if not data.exists():
        return float("nan")
    report = subprocess.run(
        ["perf", "report", f"--input={data}", "--sort=dso", "--stdio", "--field-separator=;"],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    shares = {}
    for line in report.splitlines():
        match = re.fullmatch(r"\s*([0-9.]+)%?\s*;\s*(\S+)\s*", line)
        if match and RENDERING.search(match[2]):
            shares[match[2]] = float(match[1])
    total = sum(shares.values())
    embree = sum(share for name, share in shares.items() if "libembree" in name)
    return embree / total if total > 0 else float("nan")
