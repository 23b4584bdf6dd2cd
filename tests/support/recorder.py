"""A renderer for tests of the validation suite that are about what it asks for."""

from __future__ import annotations

from dataclasses import replace

from etendue.image import Image
from etendue.validation.cases.tilted_facet import facet_shot
from etendue.validation.shots import Shot, render

#: The least that can be rendered.
FACET = facet_shot("light", "matte", 0.0, 0.0, 0.0)


class Recorder:
    """Renders as little as can be, and remembers what was asked for. Pictures that are only looked
    at, not measured, it makes small."""

    def __init__(self) -> None:
        self.asked: list[tuple[Shot, int, int]] = []

    def __call__(self, shot: Shot, spp: int, seed: int) -> Image:
        self.asked.append((shot, spp, seed))
        looked_at = shot.resolution[0] >= 160 and not shot.aovs
        return render(replace(shot, resolution=(16, 12)) if looked_at else shot, 1, seed)
