"""Writes a stage's colour in many formats of render buffers.

buffers.py STAGE CAMERA WIDTH HEIGHT DIRECTORY
"""

from __future__ import annotations

import ctypes
import os
import sys


def main(stage: str, camera: str, width: int, height: int, directory: str) -> None:
    """See the module and buffers.cpp."""
    library = ctypes.CDLL(os.environ["ETENDUE_HYDRA_PICKING"])
    library.write_buffers(stage.encode(), camera.encode(), width, height, directory.encode())


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), sys.argv[5])
