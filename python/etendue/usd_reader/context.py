"""What every part of the reader shares while one stage is read."""

from __future__ import annotations

import shutil
import tempfile
import weakref
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import numpy.typing as npt
from pxr import Gf, Usd

from etendue import _core
from etendue.usd_reader.report import Report

Matrix = npt.NDArray[np.float64]


class Scratch:
    """A directory for files taken out of packages: made on first use, removed with this object."""

    def __init__(self) -> None:
        self._directory: Path | None = None

    @property
    def directory(self) -> Path:
        """Where to put files."""
        if self._directory is None:
            self._directory = Path(tempfile.mkdtemp(prefix="etendue-"))
            weakref.finalize(self, shutil.rmtree, self._directory, ignore_errors=True)
        return self._directory


@dataclass
class ReadContext:
    """The stage, the time code that it is read at, and the scene under construction."""

    stage: Usd.Stage
    time: Usd.TimeCode
    source: str
    purposes: frozenset[str] = frozenset({"default", "render"})
    material_purpose: str = "full"
    scene: _core.SceneDescription = field(default_factory=_core.SceneDescription)
    report: Report = field(default_factory=Report)
    scratch: Scratch = field(default_factory=Scratch)


def column_matrix(matrix: Gf.Matrix4d) -> Matrix:
    """The matrix for column vectors, (4, 4): USD's is for row vectors, its transpose."""
    return np.array(matrix, dtype=np.float64).T
