"""Prints what pixels of a stage show: prim, instance and face, a line each.

picking.py STAGE CAMERA WIDTH HEIGHT X Y [X Y...]
"""

from __future__ import annotations

import ctypes
import os
import sys


def main(stage: str, camera: str, *numbers: str) -> None:
    """See the module; the library is beside the plugin."""
    library = ctypes.CDLL(os.environ["ETENDUE_HYDRA_PICKING"])
    width, height, *pixels = map(int, numbers)
    array = (ctypes.c_int * len(pixels))(*pixels)
    library.print_picked(stage.encode(), camera.encode(), width, height, array, len(pixels) // 2)


if __name__ == "__main__":
    main(*sys.argv[1:])
