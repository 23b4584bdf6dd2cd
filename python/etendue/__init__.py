"""Etendue, a bidirectional path tracer for USD.

import etendue

stage = etendue.open("caustic_pool.usda")
image = stage.render(spp=64)
image.save("caustic_pool.png")
"""

from etendue._core import RenderProgress, RenderStatistics, __version__
from etendue.comparison import Comparison, compare
from etendue.exceptions import (
    ComparisonError,
    Error,
    EtendueWarning,
    FileError,
    Interrupted,
    SceneError,
    SettingsError,
    TradeoffInterrupted,
    ValidationInterrupted,
)
from etendue.image import Image
from etendue.inspection import Inspection
from etendue.session import Session
from etendue.settings import RenderOptions
from etendue.stage import Stage
from etendue.stage import open_stage as open  # noqa: A004 - reads etendue.open(...)
from etendue.tradeoff import TradeoffResult, tradeoff
from etendue.usd_reader import StageWarning
from etendue.validation import ValidationResult, validate

__all__ = [
    "Comparison",
    "ComparisonError",
    "Error",
    "EtendueWarning",
    "FileError",
    "Image",
    "Inspection",
    "Interrupted",
    "RenderOptions",
    "RenderProgress",
    "RenderStatistics",
    "SceneError",
    "Session",
    "SettingsError",
    "Stage",
    "StageWarning",
    "TradeoffInterrupted",
    "TradeoffResult",
    "ValidationInterrupted",
    "ValidationResult",
    "__version__",
    "compare",
    "open",
    "tradeoff",
    "validate",
]
