"""The add-on, from the directory that ETENDUE_BLENDER_ADDONS names."""

from __future__ import annotations

import os
import sys

sys.path.insert(0, os.environ["ETENDUE_BLENDER_ADDONS"])
import etendue_hydra

__all__ = ["etendue_hydra"]
