#include "support/bsdf_cases.h"

#include <cmath>
#include <cstdio>

#include "math/sampling.h"

namespace etendue::test {
namespace {

std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", x);
    return text;
}

BsdfCase conductor(double alpha) {
    return {"conductor alpha " + number(alpha), Conductor(Rgb(1), alpha), 1, std::max(alpha, 1e-12), true, true};
}

BsdfCase dielectric(double ior, double alpha) {
    // Refraction narrows a lobe by about |ior - 1| at most.
    const double width = alpha * std::min(1.0, std::abs(ior - 1));
    return {"dielectric ior " + number(ior) + " alpha " + number(alpha),
            Dielectric(ior, alpha),
            ior,
            std::max(width, 1e-12),
            false,
            true};
}

LayeredParameters plastic(double alpha, double f0) {
    LayeredParameters p;
    p.alpha = alpha;
    p.coated = 1;
    p.coat_f0 = Rgb(f0);
    p.coat_f90 = Rgb(1);
    p.diffuse = Rgb(1);
    return p;
}

/// A bit of everything.
LayeredParameters mixture(double alpha) {
    LayeredParameters p = plastic(alpha, 0.04);
    p.presence = 0.85;
    p.metal = 0.3;
    p.coated = 0.3;
    p.glass = 0.4;
    p.metal_fresnel = {{0.9, 0.6, 0.3}, Rgb(1), Rgb(0.4)};
    p.coat_tint = {0.9, 1, 0.8};
    p.diffuse = {0.2, 0.7, 0.5};
    p.glass_model = Dielectric(1.5, alpha, {0.9, 1, 0.8}, {1, 0.8, 0.7});
    return p;
}

LayeredParameters veiled(double alpha, double veil, double ior) {
    LayeredParameters p = plastic(alpha, 0);
    p.coated = 1 - veil;
    p.veil = veil;
    p.veil_ior = ior;
    p.coat_f0 = {0.1, 0.04, 0.06};
    return p;
}

BsdfModel clearcoated(LayeredParameters p, const Clearcoat& clearcoat) {
    p.clearcoat = clearcoat;
    return Layered(p);
}

LayeredParameters white_metal(double alpha) {
    LayeredParameters p;
    p.alpha = alpha;
    p.metal = 1;
    p.metal_fresnel = {Rgb(1), Rgb(1), Rgb()};
    return p;
}

void add_clearcoats(std::vector<BsdfCase>& cases) {
    const auto add = [&](const std::string& below, const LayeredParameters& p, const Clearcoat& clearcoat, double width,
                         bool white) {
        const bool two_sided = p.veil == 0 && p.glass == 0;
        const double ior = p.veil > 0 ? p.veil_ior : p.glass > 0 ? 1.5 : 1;
        cases.push_back({"clearcoat alpha " + number(clearcoat.alpha) + " over " + below, clearcoated(p, clearcoat),
                         ior, width, two_sided, white});
    };
    add("mirror", white_metal(0), {0, 0.04, 1}, 1, true);
    add("veil", veiled(0, 1, 1.5), {0, 0.02, 0.5}, 1, true);
    add("plastic", plastic(0.25, 0.04), {0, 0.04, 1}, 0.25, true);
    add("metal", white_metal(0.25), {0.04, 0.02, 0.5}, 0.04, true);
    add("mixture", mixture(0.09), {0.64, 0.04, 1}, 0.04, false);
    add("smooth mixture", mixture(0), {0.25, 0.04, 1}, 1, false);
}

std::vector<BsdfCase> make_cases() {
    std::vector<BsdfCase> cases;
    cases.push_back({"diffuse", Diffuse(Rgb(1)), 1, 1, true, true});
    for (double roughness : {0.3, 1.0}) {
        cases.push_back({"diffuse roughness " + number(roughness), RoughDiffuse(Rgb(1), roughness), 1, 1, true, true});
    }
    for (double alpha : {0.0, 1e-4, 0.01, 0.09, 0.25, 1.0}) cases.push_back(conductor(alpha));
    for (double ior : {1.5, 1 / 1.5}) {
        for (double alpha : {0.0, 1e-3, 0.04, 0.25, 1.0}) cases.push_back(dielectric(ior, alpha));
    }
    cases.push_back(dielectric(2.4, 0.09));
    cases.push_back(dielectric(1.02, 0.25));
    cases.push_back(dielectric(1, 0.25));
    cases.push_back(
        {"tinted dielectric", Dielectric(1.333, 0.1, {1, 0.5, 0.2}, {0.1, 0.3, 0.2}), 1.333, 0.03, false, false});
    cases.push_back({"plastic alpha 0", Layered(plastic(0, 0.04)), 1, 1, true, true});
    cases.push_back({"plastic alpha 0.001", Layered(plastic(0.001, 0.04)), 1, 0.001, true, true});
    cases.push_back({"plastic alpha 0.25", Layered(plastic(0.25, 0.04)), 1, 0.25, true, true});
    cases.push_back({"plastic alpha 1, f0 0.8", Layered(plastic(1, 0.8)), 1, 1, true, true});
    cases.push_back({"mixture alpha 0", Layered(mixture(0)), 1.5, 1, false, false});
    cases.push_back({"mixture alpha 0.09", Layered(mixture(0.09)), 1.5, 0.04, false, false});
    cases.push_back({"veil alpha 0", Layered(veiled(0, 1, 1.5)), 1.5, 1, false, true});
    cases.push_back({"half a veil alpha 0.16", Layered(veiled(0.16, 0.5, 1.5)), 1.5, 0.16, false, true});
    cases.push_back({"half a veil alpha 0.09, ior 1", Layered(veiled(0.09, 0.5, 1)), 1, 0.09, false, true});
    for (double exponent : {0.0, 8.0, 5000.0}) {
        const double width = std::min(1.0, std::sqrt(2 / (exponent + 1)));
        for (PhongForm form : {PhongForm::Modified, PhongForm::Classic}) {
            const bool modified = form == PhongForm::Modified;
            if (modified == (exponent == 0)) continue;  // the forms share their density
            cases.push_back({(modified ? "modified Phong " : "classic Phong ") + number(exponent),
                             Phong(Rgb(0.9, 0.6, 0.3), exponent, form), 1, width, true, false, modified});
        }
    }
    for (double alpha : {0.0, 0.01, 0.16, 1.0}) {
        const double width = std::max(0.3 * alpha, 1e-12);
        cases.push_back(
            {"pane alpha " + number(alpha), Dielectric(1.5, alpha, Rgb(1), Rgb(1), true), 1, width, false, true});
    }
    cases.push_back(
        {"tinted pane of ior 0.8", Dielectric(0.8, 0.3, {1, 0.5, 0.2}, {0.1, 0.3, 0.2}, true), 1, 0.04, false, false});
    LayeredParameters panes = mixture(0.09);
    panes.glass_model = Dielectric(1.5, 0, {0.9, 1, 0.8}, {1, 0.8, 0.7}, true);
    cases.push_back({"mixture with a pane", Layered(panes), 1, 0.09, true, false});
    LayeredParameters rough_base = plastic(0.25, 0.04);
    rough_base.diffuse_roughness = 0.7;
    cases.push_back({"plastic of rough base", Layered(rough_base), 1, 0.25, true, true});
    add_clearcoats(cases);
    return cases;
}

}  // namespace

const std::vector<BsdfCase>& bsdf_cases() {
    static const std::vector<BsdfCase> cases = make_cases();
    return cases;
}

Bsdf flat(const BsdfModel& model) { return Bsdf(model, Frame::from_normal({0, 0, 1}), {0, 0, 1}); }

Bsdf tilted(const BsdfModel& model) { return Bsdf(model, Frame::from_normal(normalize({0.35, -0.2, 1})), {0, 0, 1}); }

Vec3 direction(double cos, double phi) {
    const double sin = std::sqrt((1 - cos) * (1 + cos));
    return {sin * std::cos(phi), sin * std::sin(phi), cos};
}

Vec3 random_direction(Rng& rng) { return sample_uniform_sphere(rng.next_2d()); }

std::optional<BsdfSample> draw(const Bsdf& bsdf, const Vec3& wo, TransportMode mode, Rng& rng,
                               const AdjointPolicy& policy) {
    const double u_lobe = rng.next_1d();
    return bsdf.sample(wo, u_lobe, rng.next_2d(), mode, policy);
}

std::optional<Vec3> sample_non_delta(const Bsdf& bsdf, const Vec3& wo, TransportMode mode, Rng& rng) {
    const std::optional<BsdfSample> sample = draw(bsdf, wo, mode, rng);
    if (!sample || sample->delta) return std::nullopt;
    return sample->wi;
}

}  // namespace etendue::test
