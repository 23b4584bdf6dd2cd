"""theory.md §5-§7 in closed form, against quadrature and values worked out by hand."""

from __future__ import annotations

from math import cos, pi, radians, sin, sqrt

import numpy as np
import numpy.typing as npt
import pytest
from scipy import integrate

from etendue.validation import predictions

WATER = 1.333


def tilted(degrees: float, azimuth: float = 0.0) -> npt.NDArray[np.float64]:
    """A unit vector so far from +z."""
    theta, phi = radians(degrees), radians(azimuth)
    return np.array([sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)])


UP = tilted(0)


# ------------------------------------------------------------------------------------- refraction


@pytest.mark.parametrize(
    ("eta", "squared"), [(1.1, 1.21), (1.333, 1.776889), (1.5, 2.25), (2.42, 5.8564)]
)
def test_one_crossing(eta: float, squared: float) -> None:
    assert predictions.crossing_ratio(1, eta) == pytest.approx(squared, rel=1e-12)
    assert predictions.crossing_ratio(eta, 1) == pytest.approx(1 / squared, rel=1e-12)


def test_crossings_multiply() -> None:
    assert predictions.crossings_ratio([1]) == 1
    assert predictions.crossings_ratio([1, 1.5]) == pytest.approx(2.25)
    assert predictions.crossings_ratio([1, 1.5, 1]) == pytest.approx(1, rel=1e-12)
    # Air, glass, water: the glass between leaves no trace.
    assert predictions.crossings_ratio([1, 1.5, 1.333]) == pytest.approx(1.776889, rel=1e-12)


def test_impossible_media() -> None:
    with pytest.raises(ValueError, match="positive"):
        predictions.crossing_ratio(1, 0)
    with pytest.raises(ValueError, match="at least one medium"):
        predictions.crossings_ratio([])


# --------------------------------------------------------------------------------- shading normals


def test_shading_normal_by_hand() -> None:
    # wi·n_g = cos 60, wo·n_s = cos 60, wi·n_s = cos 30, wo·n_g = cos 30.
    ratio = predictions.shading_normal_ratio(tilted(30), UP, tilted(60), tilted(-30))
    assert ratio == pytest.approx(1 / 3, rel=1e-12)


def test_shading_normal_of_a_true_normal_is_right() -> None:
    args = tilted(17, 40), tilted(17, 40), tilted(50, 10), tilted(70, 80)
    assert predictions.shading_normal_ratio(*args) == pytest.approx(1, rel=1e-12)


def test_shading_normal_is_its_inverse_seen_in_reverse() -> None:
    n_s, wi, wo = tilted(20, 30), tilted(50, 10), tilted(40, 200)
    there = predictions.shading_normal_ratio(n_s, UP, wi, wo)
    assert there != pytest.approx(1, rel=0.1)
    assert there * predictions.shading_normal_ratio(n_s, UP, wo, wi) == pytest.approx(1, rel=1e-12)


def test_shading_normal_against_particles_on_a_facet() -> None:
    """A Lambertian facet, n_s tilted, under a distant light of irradiance 1 across its beam. Its
    radiance towards an eye by the definition of the BSDF, and by energy as the wrong code has it:
    particles hit with |wi·n_g|, scatter by the density |wo·n_s| / pi per solid angle (the cosine
    of n_s for n_g) and spread over the projected area |wo·n_g|."""
    n_s, wi, wo = tilted(25, 15), tilted(55, 60), tilted(35, 250)
    right = float(wi @ n_s) / pi
    wrong = (wi @ UP) * (wo @ n_s) / pi / (wo @ UP)
    ratio = predictions.shading_normal_ratio(n_s, UP, wi, wo)
    assert ratio == pytest.approx(wrong / right, rel=1e-12)


def test_shading_normal_blend_over_all_light_by_quadrature() -> None:
    """Under a uniform sky the right facet has radiance 1; the wrong one's comes out by the cosine
    of n_g: for a facet whose hemispheres agree where there is light, |wo·n_s| / |wo·n_g| times the
    mean of |wi·n_g| over the light. The sky is a cap of 30 degrees around n_g."""
    n_s, wo = tilted(20), tilted(40)
    cosines = np.linspace(cos(radians(30)), 1, 401)
    azimuths = np.linspace(0, 360, 361)[:-1]
    wrong = right = 0.0
    for cosine in (cosines[1:] + cosines[:-1]) / 2:
        for azimuth in azimuths[::8]:
            wi = tilted(float(np.degrees(np.arccos(cosine))), float(azimuth))
            wrong += float(wi @ n_s) * predictions.shading_normal_ratio(n_s, UP, wi, wo)
            right += float(wi @ n_s)
    # By hand: the means of wi·n_g and wi·n_s over the cap are m and m cos 20.
    expected = cos(radians(20)) / cos(radians(40)) / cos(radians(20))
    assert wrong / right == pytest.approx(expected, rel=1e-6)


def test_nothing_reflects_between_the_sides() -> None:
    with pytest.raises(ValueError, match="nothing is reflected"):
        predictions.shading_normal_ratio(tilted(40), UP, tilted(-60), tilted(10))
    with pytest.raises(ValueError, match="nothing is reflected"):
        predictions.phong_ratio(UP, tilted(20), tilted(100))


# ------------------------------------------------------------------------------------------- Phong


def test_phong() -> None:
    assert predictions.phong_ratio(UP, tilted(60), tilted(0)) == pytest.approx(0.5)
    assert predictions.phong_ratio(UP, tilted(45), tilted(60)) == pytest.approx(sqrt(2))


def test_phong_against_the_form_itself() -> None:
    def classic(wi: npt.NDArray[np.float64], wo: npt.NDArray[np.float64]) -> float:
        mirrored = 2 * (wo @ UP) * UP - wo
        return float(max(0.0, float(wi @ mirrored)) ** 20 / abs(wi @ UP))

    wi, wo = tilted(30), tilted(-40)
    # Code without the adjoint hands the known direction, wi, over as the one it looks from.
    wrong, right = classic(wo, wi), classic(wi, wo)
    assert wrong / right == pytest.approx(predictions.phong_ratio(UP, wi, wo), rel=1e-12)


# ----------------------------------------------------------------------------------------- Fresnel


def test_fresnel_at_normal_incidence() -> None:
    assert predictions.fresnel_reflectance(1, WATER) == pytest.approx((0.333 / 2.333) ** 2)
    assert predictions.fresnel_reflectance(1, 1 / WATER) == pytest.approx((0.333 / 2.333) ** 2)


def test_fresnel_at_brewsters_angle() -> None:
    # tan θ = η: only light polarised across the plane is reflected, by ((η² - 1) / (η² + 1))².
    reflectance = predictions.fresnel_reflectance(1 / sqrt(1 + 1.5**2), 1.5)
    assert reflectance == pytest.approx((1.25 / 3.25) ** 2 / 2, rel=1e-12)


def test_fresnel_ends() -> None:
    assert predictions.fresnel_reflectance(0, WATER) == 1
    assert predictions.fresnel_reflectance(0.3, 1) == pytest.approx(0, abs=1e-30)
    # The critical angle of glass is 41.8 degrees.
    assert predictions.fresnel_reflectance(cos(radians(42)), 1 / 1.5) == 1
    assert predictions.fresnel_reflectance(cos(radians(41.5)), 1 / 1.5) < 1
    with pytest.raises(ValueError, match="no reflectance"):
        predictions.fresnel_reflectance(1.5, WATER)


# ------------------------------------------------------------------------------------------- floor


def test_floor_under_the_zenith() -> None:
    expected = 3 * (1 - (0.333 / 2.333) ** 2)
    assert predictions.floor_irradiance(3, 1, WATER) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("degrees", [0.0, 30.0, 60.0, 80.0])
@pytest.mark.parametrize("eta", [1.1, WATER, 1.5, 2.42])
def test_floor_by_quadrature_of_radiance_in_water(degrees: float, eta: float) -> None:
    """A ring of sky of radiance 1, 0.2 degrees wide around the angle. In the water its radiance is
    eta^2 (1 - F), and Snell's law gives the narrower ring; its irradiance is integrated there, over
    the refracted angles, with F by Fresnel's own sine and tangent laws. The tolerance is what the
    integrand's curvature makes of the ring's width.
    """
    edges = np.radians([max(0.0, degrees - 0.1), degrees + 0.1])
    first, last = np.arcsin(np.sin(edges) / eta)
    inside = np.linspace(first, last, 2001)
    middle = (inside[1:] + inside[:-1]) / 2
    outside = np.arcsin(eta * np.sin(middle))
    across = (np.sin(outside - middle) / np.sin(outside + middle)) ** 2
    along = (np.tan(outside - middle) / np.tan(outside + middle)) ** 2
    radiance = eta**2 * (1 - (across + along) / 2)
    floor = 2 * pi * np.sum(radiance * np.cos(middle) * np.sin(middle)) * (inside[1] - inside[0])
    # The irradiance that the ring makes across its beam: radiance times solid angle.
    beam = 2 * pi * (cos(edges[0]) - cos(edges[1]))
    predicted = predictions.floor_irradiance(beam, cos(radians(degrees)), eta)
    assert floor == pytest.approx(predicted, rel=2e-4)


@pytest.mark.parametrize("eta", [1.0, WATER, 2.42])
@pytest.mark.parametrize("depth", [0.0, 1.0])
def test_floor_straight_below_a_lamp(eta: float, depth: float) -> None:
    """Its beam is narrowed by the water as if the depth were depth / eta."""
    middle = predictions.floor_irradiance_under_lamp(32, 2.5, depth, eta, 0.0)
    transmitted = 1 - ((eta - 1) / (eta + 1)) ** 2
    assert float(middle) == pytest.approx(32 * transmitted / (2.5 + depth / eta) ** 2, rel=1e-6)


def test_floor_under_a_lamp_without_water() -> None:
    """The inverse square of the distance, the lamp's cosine and the floor's."""
    radius = np.array([[0.0, 0.3], [1.0, 8.0]])
    distance = np.hypot(radius, 3.5)
    found = predictions.floor_irradiance_under_lamp(32, 2.5, 1.0, 1.0, radius)
    np.testing.assert_allclose(found, 32 * (3.5 / distance) ** 2 / distance**2, rtol=1e-5)


@pytest.mark.parametrize("eta", [1.1, WATER, 2.42])
def test_floor_under_a_lamp_receives_what_enters_the_water(eta: float) -> None:
    """Within the ring of the floor where light arrives that leaves the lamp at 60 degrees, and over
    nearly all of it: the flux is counted on the surface, by the lamp's solid angle and its cosine,
    and on the floor, by area."""
    height, depth = 2.5, 1.0
    for angle in (radians(60), radians(84)):
        edge = height * np.tan(angle) + depth * np.tan(np.arcsin(sin(angle) / eta))
        # Narrow rings near the middle, where most of the light is.
        radius = edge * np.linspace(0, 1, 20_001) ** 2
        floor = predictions.floor_irradiance_under_lamp(32, height, depth, eta, radius)
        theta = np.linspace(0, angle, 2001)
        entering = [1 - predictions.fresnel_reflectance(float(c), eta) for c in np.cos(theta)]
        surface = 2 * pi * 32 * integrate.trapezoid(entering * np.cos(theta) * np.sin(theta), theta)
        assert 2 * pi * integrate.trapezoid(floor * radius, radius) == pytest.approx(
            surface, rel=1e-5
        )


def test_floor_without_prediction() -> None:
    """Light steeper than 85 degrees is not followed, nor light that leaves the dense side."""
    with pytest.raises(ValueError, match="85 degrees"):
        predictions.floor_irradiance_under_lamp(32, 2.5, 1.0, WATER, [0.0, 40.0])
    with pytest.raises(ValueError, match="no less than 1"):
        predictions.floor_irradiance_under_lamp(32, 2.5, 1.0, 1 / WATER, 0.0)
