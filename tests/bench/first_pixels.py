"""Opens a stage, renders one sample per pixel in one thread, and prints as JSON what that took.

A process of its own, so that peak memory is this render's alone.
"""

from __future__ import annotations

import json
import re
import sys
import time
from pathlib import Path

import etendue


def peak_memory() -> int:
    """Bytes. (getrusage's figure may be that of whoever started the process.)"""
    found = re.search(r"VmHWM:\s*(\d+) kB", Path("/proc/self/status").read_text(encoding="utf-8"))
    assert found
    return int(found[1]) * 1024


def main() -> None:
    at = [time.process_time()]
    stage = etendue.open(sys.argv[1])
    at.append(time.process_time())
    session = stage.session(resolution=(64, 64), spp=1, integrator="path", threads=1, last=True)
    at.append(time.process_time())
    session.run()
    at.append(time.process_time())
    use = session.memory_use
    names = ("reading the stage", "conversion and Embree's build", "the first pass")
    told = {
        "seconds": {name: at[i + 1] - at[i] for i, name in enumerate(names)},
        "memory": {part: getattr(use, part) for part in ("vertices", "acceleration", "film")},
        "peak": peak_memory(),
    }
    print(json.dumps(told))


if __name__ == "__main__":
    main()
