"""Interpolated normals and normal maps, in pictures."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from etendue.arrays import FloatArray
from etendue.validation.case import Case, Outcome
from etendue.validation.claims import BlendEvidence, Claim, is_wrong
from etendue.validation.effort import Effort
from etendue.validation.errors import CORRECTIONS, inverted
from etendue.validation.pairs import same_picture
from etendue.validation.pictures import picture_pair
from etendue.validation.results import PicturePair
from etendue.validation.shading_maps import predicted_ratio_map
from etendue.validation.shots import Shot, Studio, Values
from etendue.validation.statistics import Samples

CORRECTION = "shading_normal"
FORMULA = "Σ |ωi·Ng| |ωo·Ns| / (|ωi·Ns| |ωo·Ng|)"
#: A pixel counts as too bright, or too dark, beyond this factor and its inverse.
NOTICED = 1.1
#: Light subpaths per pixel and sample of the pictures: nothing else is seen in them.
PICTURE_LIGHT_PATHS = 8.0


@dataclass(frozen=True)
class Subject:
    """A stage with shading normals and one small lamp."""

    name: str
    shot: Shot
    without_normals: Values
    """What takes the shading normals away."""
    lamp: tuple[float, float, float]
    title: str
    caption: str


PLANE = Subject(
    name="bump plane",
    shot=Shot(
        stage="bump_plane.usda",
        camera="/cameras/main",
        integrator="light",
        resolution=(48, 36),
        max_depth=1,
    ),
    without_normals={"/World/Materials/Bumps/Surface.inputs:normal": None},
    lamp=(-2.2, 1.4, -0.8),
    title="A normal map on one flat quad",
    caption="The bumps' slopes are exaggerated on one side and flattened on the other.",
)
SPHERES = Subject(
    name="bump spheres",
    shot=Shot(
        stage="bump_sphere.usda",
        camera="/cameras/main",
        integrator="light",
        resolution=(64, 36),
        max_depth=1,
        values={"/Lights/Sky.inputs:intensity": 0.0},
    ),
    without_normals={
        "/World/Smooth/Mesh.normals": None,
        "/World/Bumpy/Mesh.normals": None,
        "/World/Materials/Bumps/Surface.inputs:normal": None,
    },
    lamp=(-2.6, 2.2, 2.3),
    title="A coarse sphere with smooth normals, one with bumps too, and an exact one",
    caption="Left: the faces show through smooth shading. Right: where geometry and shading agree "
    "nothing changes.",
)


def _agreement(studio: Studio, effort: Effort, subject: Subject) -> list[Claim]:
    """Path, light and bdpt, at full depth and with all lights."""
    light = replace(subject.shot, max_depth=16, values={})
    path = light.by("path")
    spp = effort.spp(64), effort.spp(16)
    blocks = (3, 4)
    return [
        same_picture(studio, light, path, spp, effort.takes, blocks, subject.name),
        same_picture(
            studio, light.by("bdpt"), path, (spp[1], spp[1]), effort.takes, blocks, subject.name
        ),
    ]


def region_claims(
    studio: Studio, effort: Effort, subject: Subject, predicted: FloatArray
) -> list[Claim]:
    """In what theory says is too bright, and in what it says is too dark."""
    spp = effort.spp(64)
    right = studio.takes(subject.shot, spp, effort.takes)
    wrong = studio.takes(subject.shot.without(CORRECTION), spp, effort.takes)
    regions = {"too bright": predicted > NOTICED, "too dark": predicted < 1 / NOTICED}
    return [
        _region_claim(subject, name, wrong[:, region], right[:, region], predicted[region])
        for name, region in regions.items()
    ]


def _region_claim(
    subject: Subject, name: str, wrong: FloatArray, right: FloatArray, predicted: FloatArray
) -> Claim:
    """Of takes (n, pixels) of a region, and its predicted ratio (pixels)."""
    evidence = BlendEvidence(
        wrong.mean(axis=1), right.mean(axis=1), (right * predicted).mean(axis=1)
    )
    claim = is_wrong(
        f"{subject.name}, {predicted.size} pixels that are {name}",
        subject.shot,
        evidence,
        formula=FORMULA,
        correction=CORRECTION,
        ratio=evidence.predicted,
    )
    # An inverted factor makes every pixel wrong by its own ratio: no power of the mean tells.
    turned = Samples((right / predicted).mean(axis=1), evidence.right).ratio
    return replace(claim, under={**claim.under, inverted(CORRECTIONS[CORRECTION]): turned})


def _pictures(studio: Studio, effort: Effort, subject: Subject) -> PicturePair:
    width, height = subject.shot.resolution
    shot = replace(
        subject.shot,
        resolution=effort.size(640, height * 640 // width),
        light_paths=PICTURE_LIGHT_PATHS,
    )
    return picture_pair(
        studio,
        shot,
        CORRECTION,
        effort.picture_spp(16),
        subject.title,
        subject.caption,
        predicted_ratio=predicted_ratio_map(studio, shot, subject.without_normals, subject.lamp, 3),
    )


def run(studio: Studio, effort: Effort) -> Outcome:
    claims: list[Claim] = []
    figures = []
    for subject in (PLANE, SPHERES):
        predicted = predicted_ratio_map(
            studio, subject.shot, subject.without_normals, subject.lamp, 8
        )
        claims += region_claims(studio, effort, subject, np.nan_to_num(predicted, nan=1.0))
        claims += _agreement(studio, effort, subject)
        figures.append(_pictures(studio, effort, subject))
    return Outcome(
        headline="facets show through smooth normals, bumps come out wrong, as predicted pixel "
        "by pixel",
        claims=tuple(claims),
        figures=tuple(figures),
    )


CASE = Case(
    name="smooth_shading",
    title="Smooth normals and bumps: what the missing factor looks like",
    lesson="""
A low-polygon sphere with interpolated normals shades like a smooth one, from the camera. By light
tracing without the factor its faces come back: within one face the geometric cosine stays, the
shading cosine varies, and the quotient jumps from face to face. With a normal map every bump is off
by its own number. The maps on the right are measured and, beside them, predicted from normals and
directions alone.

With the factor path, light and bidirectional path tracing agree in every block of the picture.
""",
    run=run,
)
