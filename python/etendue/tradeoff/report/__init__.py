"""A TradeoffResult as files and in a terminal."""

from etendue.tradeoff.report.files import write_report
from etendue.tradeoff.report.terminal import summary_table

__all__ = ["summary_table", "write_report"]
