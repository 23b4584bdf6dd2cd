"""What Etendue raises and warns with, besides the errors of the core."""

from __future__ import annotations

from typing import TYPE_CHECKING

from etendue._core import Error, FileError, SceneError, SettingsError

if TYPE_CHECKING:
    from etendue.image import Image
    from etendue.tradeoff.results import TradeoffResult
    from etendue.validation.results import ValidationResult

__all__ = [
    "ComparisonError",
    "Error",
    "EtendueWarning",
    "FileError",
    "Interrupted",
    "SceneError",
    "SettingsError",
    "TradeoffInterrupted",
    "ValidationInterrupted",
]


class ComparisonError(Error):
    """Pictures cannot be compared with each other, each being good by itself."""


class EtendueWarning(UserWarning):
    """Something in a stage is not supported or not usable, and was left out or replaced."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a render. `image` holds what had been rendered by then."""

    def __init__(self, image: Image) -> None:
        super().__init__("the render was interrupted")
        self.image = image


class ValidationInterrupted(KeyboardInterrupt):
    """Ctrl-C during a validation. `result` holds the cases that had finished by then."""

    def __init__(self, result: ValidationResult) -> None:
        super().__init__("the validation was interrupted")
        self.result = result


class TradeoffInterrupted(KeyboardInterrupt):
    """Ctrl-C during etendue.tradeoff(). `result` holds what had been rendered by then."""

    def __init__(self, result: TradeoffResult) -> None:
        super().__init__("the measurement was interrupted")
        self.result = result
