"""Hydra has no order of its own but that of paths."""

from __future__ import annotations

from pathlib import Path

from pxr import Usd


def open_in_path_order(file: Path) -> Usd.Stage:
    """The stage with all children sorted by name: read in that order it draws the same samples as
    through Hydra. The numbers of shapes and lights decide which of them a sample goes to.
    """
    stage = Usd.Stage.Open(str(file))
    stage.SetEditTarget(stage.GetSessionLayer())
    for prim in (stage.GetPseudoRoot(), *stage.TraverseAll()):
        prim.SetChildrenReorder(sorted(child.GetName() for child in prim.GetAllChildren()))
    return stage
