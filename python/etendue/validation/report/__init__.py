"""A ValidationResult as files and in a terminal."""

from etendue.validation.report.files import write_report
from etendue.validation.report.terminal import summary_table

__all__ = ["summary_table", "write_report"]
