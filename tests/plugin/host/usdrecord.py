"""Runs usdrecord, the script that ETENDUE_USDRECORD names: bpy has its modules, not the program.

usdrecord.py ARGUMENTS...
"""

from __future__ import annotations

import os
import runpy
import sys


def main() -> None:
    """Ends as the script does."""
    status: object = 0
    try:
        runpy.run_path(os.environ["ETENDUE_USDRECORD"], run_name="__main__")
    except SystemExit as end:
        status = end.code
    sys.stdout.flush()
    sys.stderr.flush()
    # At once: a thread of USD's still takes down the stage, and aborts if Python has gone before.
    os._exit(status if isinstance(status, int) else int(status is not None))


if __name__ == "__main__":
    main()
