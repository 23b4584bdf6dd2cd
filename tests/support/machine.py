"""What a measurement was made on."""

from __future__ import annotations

import platform
from pathlib import Path


def machine() -> str:
    """The processor, as Linux names it."""
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()
