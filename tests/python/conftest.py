"""Fixtures of the Python tests."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from support.browser import chromium
from support.stage_builder import StageBuilder


@pytest.fixture
def build() -> StageBuilder:
    """An empty stage to build on."""
    return StageBuilder()


@pytest.fixture
def ctrl_c_interrupts() -> Iterator[None]:
    """A shell that starts the tests in the background has SIGINT ignored, by them and by whatever
    they start."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def picture(tmp_path: Path) -> Path:
    """A file that stands for a texture; the reader does not look inside."""
    file = tmp_path / "picture.png"
    file.write_bytes(b"not looked at")
    return file


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Chromium. It ends with the module: while it runs, asyncio is taken."""
    with chromium() as started:
        yield started
