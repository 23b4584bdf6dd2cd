"""Etendue's bdpt against other renderers, picture by picture."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

import numpy as np

from parity.cases import BDPT, CASES, Case, Peer
from parity.plain_scene import Floats
from parity.processes import RendererProcess
from parity.statistics import Comparison, compare
from parity.tasks import Method
from support.marked_table import Row, between_markers, replace_between_markers, table, table_rows

WIDTH = 64
REPLICAS = 12

HEAD = (
    "stage",
    "depth",
    "bdpt against",
    "mean, theirs / ours (p)",
    "blocks, rms difference (expected)",
    "largest z",
    "p",
    "verdict",
)


def check(case: Case, effort: float, pictures: Path | None) -> Iterator[tuple[Peer, Comparison]]:
    """Compares with every peer; `effort` multiplies the samples. Means go to `pictures`."""
    ours = _replicas(case, BDPT, case.spp, effort, pictures)
    for peer in case.peers:
        other = _replicas(case, peer.method, peer.spp, effort, pictures)
        yield peer, compare(ours, other)


def row(case: Case, peer: Peer, comparison: Comparison) -> Row:
    """Of the table."""
    c = comparison
    return (
        case.name,
        str(case.max_depth),
        str(peer.method),
        f"{c.ratio:.4f} ± {c.ratio_error:.4f} ({c.mean_p:.2g})",
        f"{c.block_rms:.2%} ({c.expected_rms:.2%})",
        f"{c.worst_z:.1f}",
        f"{c.block_p:.2g}",
        "agrees" if c.verdict == "agrees" else f"**{c.verdict}**",
    )


def write(document: Path, rows: Iterable[Row]) -> None:
    """Puts rows into the document's table, beside those of it that were not measured again."""
    known = table_rows(between_markers(document, "parity"))
    by_key = {(row[0], row[2]): row for row in (*known, *rows)}
    keys = [(case.name, str(peer.method)) for case in CASES for peer in case.peers]
    text = table(HEAD, [by_key[key] for key in keys if key in by_key])
    replace_between_markers(document, "parity", text)


def _replicas(case: Case, method: Method, spp: int, effort: float, pictures: Path | None) -> Floats:
    samples = max(1, round(spp * effort))
    with RendererProcess(case.task(method, WIDTH)) as renderer:
        images = np.array([renderer.render(samples, seed).image for seed in range(REPLICAS)])
    if pictures is not None:
        np.save(pictures / f"{case.name} {method}.npy", images.mean(0))
    return images
