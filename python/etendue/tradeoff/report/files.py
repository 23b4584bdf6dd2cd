"""A TradeoffResult in a folder."""

from __future__ import annotations

from pathlib import Path

from etendue.report_folder import Folder, write_files
from etendue.tradeoff.report.csv_file import as_csv
from etendue.tradeoff.report.json_file import as_json
from etendue.tradeoff.report.page import as_html
from etendue.tradeoff.results import TradeoffResult


def write_report(result: TradeoffResult, directory: Folder) -> Path:
    """The page to look at; raises what write_files() raises."""
    return write_files(
        directory, lambda: as_json(result), lambda: as_csv(result), lambda: as_html(result)
    )
