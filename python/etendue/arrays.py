"""Types of arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
#: As a file has them: 8k x 4k of them, in doubles, would take a gigabyte for each picture.
Pixels = npt.NDArray[np.floating[Any]]
BoolArray = npt.NDArray[np.bool_]
