"""Fixtures of the Python tests."""

from __future__ import annotations

import pytest

from support.stage_builder import StageBuilder


@pytest.fixture
def build() -> StageBuilder:
    """An empty stage to build on."""
    return StageBuilder()
