"""Error against time, of the ways to render a stage: measured, fitted, shown."""

from etendue.tradeoff.candidates import candidate_names
from etendue.tradeoff.results import CandidateResult, Choice, TradeoffResult
from etendue.tradeoff.runner import tradeoff

__all__ = ["CandidateResult", "Choice", "TradeoffResult", "candidate_names", "tradeoff"]
