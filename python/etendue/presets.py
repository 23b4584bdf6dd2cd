"""Named points on the dial between speed and accuracy. tests/honesty/README.md has what they take
and give, measured."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Preset:
    """Options that others given with it replace one by one."""

    error: float
    """Relative error that ends the render."""
    max_depth: int
    """Bounces. Light that takes more is missing, which no error target can tell."""
    spp: int
    """Ends renders that do not get there, for the rare bright spots they keep finding."""


PRESETS = {
    "draft": Preset(error=0.2, max_depth=6, spp=128),
    "preview": Preset(error=0.1, max_depth=8, spp=512),
    "final": Preset(error=0.03, max_depth=16, spp=8192),
    "reference": Preset(error=0.01, max_depth=64, spp=65536),
}
