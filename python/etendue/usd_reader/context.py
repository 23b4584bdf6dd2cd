"""What every part of the reader shares while one stage is read."""

from __future__ import annotations

import shutil
import tempfile
import weakref
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType

import numpy as np
import numpy.typing as npt
from pxr import Gf, Tf, Usd

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


class SkippingUnusable:
    """A block that is left, with a warning, when an attribute of the prim has the wrong type."""

    def __init__(self, context: ReadContext, prim: Usd.Prim) -> None:
        self._context = context
        self._prim = prim

    def __enter__(self) -> None:
        pass

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> bool:
        if not isinstance(error, TypeError | ValueError | Tf.ErrorException):
            return False
        path = self._prim.GetPath()
        self._context.report.warn(
            f"unusable {path}",
            path,
            f"the {self._prim.GetTypeName()} is skipped: an attribute has a value of a wrong type",
        )
        return True


def column_matrix(matrix: Gf.Matrix4d) -> Matrix:
    """The matrix for column vectors, (4, 4): USD's is for row vectors, its transpose."""
    return np.array(matrix, dtype=np.float64).T
