"""Where a run of the suite took place."""

from __future__ import annotations

import datetime
import os
import platform
from importlib import metadata
from pathlib import Path

from etendue import _core

_PACKAGES = ("numpy", "scipy", "usd-core")


def environment() -> dict[str, str]:
    """Versions, machine, time."""
    return {
        "etendue": _core.__version__,
        "python": platform.python_version(),
        **{name: metadata.version(name) for name in _PACKAGES},
        "system": f"{platform.system()} {platform.release()}",
        "processor": _processor(),
        "cores": str(len(os.sched_getaffinity(0))),
        "date": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
    }


def _processor() -> str:
    """By its own name where Linux tells it."""
    info = Path("/proc/cpuinfo")
    if info.exists():
        for line in info.read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.machine()
