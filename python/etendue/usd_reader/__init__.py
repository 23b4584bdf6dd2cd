"""Reads USD stages into scene descriptions. The only package that knows pxr."""

from etendue.usd_reader.report import StageWarning
from etendue.usd_reader.stage import StageContents, StageLike, read_stage

__all__ = ["StageContents", "StageLike", "StageWarning", "read_stage"]
