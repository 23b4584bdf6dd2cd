"""Fixtures of the tests of the Hydra plugin."""

from __future__ import annotations

import pytest

from support.hydra_host import HydraHost, hydra_host


@pytest.fixture(scope="session")
def host() -> HydraHost:
    """Where the plugin runs; without one the tests are skipped, and say so."""
    return hydra_host()
