"""Brightness errors of renderers without the adjoint corrections: predicted, measured, shown."""

from etendue.validation.results import CaseResult, Check, Estimate, ValidationResult
from etendue.validation.runner import case_names, validate

__all__ = ["CaseResult", "Check", "Estimate", "ValidationResult", "case_names", "validate"]
