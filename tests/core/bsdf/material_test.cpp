// What materials' parameters mean, and that a point pays for nothing it does not have.

#include "bsdf/material.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bsdf/fresnel.h"
#include "bsdf/material_models.h"
#include "core/io/temporary_directory.h"
#include "math/constants.h"
#include "support/bsdf_cases.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Textures of one value each.
class MaterialTest : public testing::Test {
protected:
    int add_texture(const std::array<double, 4>& value) {
        TextureDesc texture;
        texture.file = directory_.file("white.ppm");
        std::ofstream(texture.file, std::ios::binary) << "P6 1 1 255\n\xff\xff\xff";
        texture.wrap_s = texture.wrap_t = TextureWrap::Clamp;
        texture.scale = {0, 0, 0, 0};
        texture.bias = value;
        textures_.push_back(texture);
        return static_cast<int>(textures_.size()) - 1;
    }

    [[nodiscard]] TextureSet textures() const { return TextureSet(textures_); }

    template <typename Material>
    [[nodiscard]] BsdfModel model(const Material& material) const {
        const TextureSet set = textures();
        return make_model(material, InputReader(set, {0.5, 0.5}));
    }

    [[nodiscard]] Bsdf bsdf(const MaterialModel& material) const {
        MaterialDesc desc;
        desc.model = material;
        const TextureSet set = textures();
        return make_bsdf(desc, set, surface());
    }

    static SurfaceInteraction surface() {
        SurfaceInteraction si;
        si.n_g = si.n_s = {0, 0, 1};
        si.dpds = {2, 0, 0};
        si.dpdt = {0, 3, 0};
        si.st = {0.5, 0.5};
        return si;
    }

    TemporaryDirectory directory_;
    std::vector<TextureDesc> textures_;
};

template <typename Model>
bool is(const BsdfModel& model) {
    return std::holds_alternative<Model>(model);
}

/// The sample of the delta lobe that the random number picks.
std::optional<BsdfSample> pick(const Bsdf& bsdf, const Vec3& wo, double u_lobe) {
    return bsdf.sample(wo, u_lobe, {0.3, 0.6}, TransportMode::Radiance, kCorrect);
}

/// Sum of the delta lobes' weights times their probabilities, reflected or transmitted: their exact albedo.
Rgb delta_albedo(const Bsdf& bsdf, const Vec3& wo, bool transmission) {
    constexpr int kN = 2000;
    Rgb sum;
    for (int i = 0; i < kN; ++i) {
        const auto s = bsdf.sample(wo, (i + 0.5) / kN, {0.3, 0.6}, TransportMode::Importance, kCorrect);
        if (s && s->delta && s->transmission == transmission) sum += s->weight / kN;
    }
    return sum;
}

TEST_F(MaterialTest, OpenPbrBecomesTheSimplestModel) {
    OpenPbrMaterial m;
    EXPECT_TRUE(is<Layered>(model(m)));
    m.specular_weight.value = 0;
    EXPECT_TRUE(is<Diffuse>(model(m)));
    m.base_diffuse_roughness.value = 0.5;
    EXPECT_TRUE(is<RoughDiffuse>(model(m)));
    m.transmission_weight.value = 1;
    EXPECT_TRUE(is<Dielectric>(model(m)));
    m.base_metalness.value = 1;
    EXPECT_TRUE(is<Conductor>(model(m)));
    m.geometry_opacity.value = 0.5;
    EXPECT_TRUE(is<Layered>(model(m)));
    m.geometry_opacity.value = 1;
    m.specular_weight.value = 1;
    m.specular_roughness.value = 0;
    EXPECT_FALSE(bsdf(m).connectible());
    // By the value at the point, wherever it comes from.
    m.base_metalness.texture = add_texture({1, 0, 0, 1});
    EXPECT_TRUE(is<Conductor>(model(m)));
}

TEST_F(MaterialTest, PreviewSurfaceBecomesTheSimplestModel) {
    PreviewSurfaceMaterial m;
    EXPECT_TRUE(is<Layered>(model(m)));
    m.metallic.value = 1;
    EXPECT_TRUE(is<Conductor>(model(m)));
    m.use_specular_workflow = true;  // metallic no longer counts; specularColor is black
    EXPECT_TRUE(is<Diffuse>(model(m)));
    m = {};
    m.ior = 1;
    EXPECT_TRUE(is<Diffuse>(model(m)));
    m = {};
    m.opacity.value = 0;
    EXPECT_TRUE(is<Layered>(model(m)));
    m.roughness.value = 0;
    EXPECT_TRUE(is<Dielectric>(model(m)));
}

TEST_F(MaterialTest, RoughnessIsPerceptual) {
    ConductorMaterial m;
    m.reflectance.value = {1, 1, 1};
    m.roughness.value = 0.5;
    const Vec3 wo = direction(0.8, 1);
    const Vec3 wi = direction(0.7, 3);
    EXPECT_EQ(bsdf(m).pdf(wo, wi), flat(Conductor(Rgb(1), 0.25)).pdf(wo, wi));
    m.roughness.value = 0;
    EXPECT_FALSE(bsdf(m).connectible());
}

TEST_F(MaterialTest, ThinWalledGlassDoesNotBend) {
    DielectricMaterial pane;
    pane.thin_walled = true;
    OpenPbrMaterial open_pbr;
    open_pbr.transmission_weight.value = 1;
    open_pbr.specular_roughness.value = 0;
    open_pbr.geometry_thin_walled = true;
    const Vec3 wo = direction(0.5, 1);
    for (const Bsdf& b : {bsdf(pane), bsdf(open_pbr)}) {
        const auto s = pick(b, wo, 0.999);
        ASSERT_TRUE(s);
        EXPECT_EQ(s->wi, -wo);
        EXPECT_NEAR(s->weight.r, 1, 1e-12);
    }
    open_pbr.transmission_weight.value = 0.5;
    EXPECT_EQ(pick(bsdf(open_pbr), wo, 0.9999)->wi, -wo);
}

TEST_F(MaterialTest, Phong) {
    PhongMaterial m;
    m.exponent.value = 7;
    const Vec3 wo = direction(0.4, 1);
    const Vec3 wi = direction(0.6, 4);
    for (PhongForm form : {PhongForm::Modified, PhongForm::Classic}) {
        m.form = form;
        EXPECT_EQ(bsdf(m).eval_cos(wo, wi, TransportMode::Radiance, kCorrect),
                  flat(Phong(Rgb(0.5), 7, form)).eval_cos(wo, wi, TransportMode::Radiance, kCorrect));
    }
    m.exponent.value = 1e300;
    EXPECT_TRUE(pick(bsdf(m), wo, 0.5));
    m.exponent.value = kNan;
    EXPECT_EQ(bsdf(m).pdf(wo, wi), flat(Phong(Rgb(0.5), 0, m.form)).pdf(wo, wi));
}

TEST_F(MaterialTest, DiffuseRoughness) {
    DiffuseMaterial m;
    m.roughness.value = 0.4;
    OpenPbrMaterial plastic;
    plastic.specular_weight.value = 0;
    plastic.base_color = m.reflectance;
    plastic.base_diffuse_roughness.value = 0.4;
    const Vec3 wo = direction(0.4, 1);
    const Vec3 wi = direction(0.3, 1.2);
    const Rgb f = bsdf(m).eval_cos(wo, wi, TransportMode::Radiance, kCorrect);
    EXPECT_EQ(f, flat(RoughDiffuse(Rgb(0.5), 0.4)).eval_cos(wo, wi, TransportMode::Radiance, kCorrect));
    EXPECT_EQ(f, bsdf(plastic).eval_cos(wo, wi, TransportMode::Radiance, kCorrect));
    m.roughness.value = 0;
    EXPECT_LT(bsdf(m).eval_cos(wo, wi, TransportMode::Radiance, kCorrect).r, f.r);  // rough sends light back
}

TEST_F(MaterialTest, PreviewSurfaceReflectsByIorOrBySpecularColor) {
    PreviewSurfaceMaterial m;
    m.roughness.value = 0;
    m.ior = 2;
    const Vec3 wo{0, 0, 1};
    EXPECT_NEAR(delta_albedo(bsdf(m), wo, false).r, 1.0 / 9, 1e-3);
    m.use_specular_workflow = true;
    m.specular_color.value = {0.5, 0.25, 0.125};
    const Rgb tinted = delta_albedo(bsdf(m), wo, false);
    EXPECT_NEAR(tinted.r, 0.5, 1e-2);
    EXPECT_NEAR(tinted.g / tinted.r, 0.5, 1e-12);
    EXPECT_NEAR(tinted.b / tinted.r, 0.25, 1e-12);
}

TEST_F(MaterialTest, PreviewSurfaceOpacity) {
    const Vec3 wo = direction(0.6, 1);
    PreviewSurfaceMaterial m;
    m.roughness.value = 0;
    m.opacity.value = 0.25;
    // Transparent: three quarters of what the highlight leaves go through, bent by the index of refraction.
    const Rgb highlight = delta_albedo(bsdf(m), wo, false);
    EXPECT_NEAR(delta_albedo(bsdf(m), wo, true).r, 0.75 * (1 - highlight.r), 2e-3);
    const auto bent = pick(bsdf(m), wo, 0.999);
    ASSERT_TRUE(bent && bent->transmission);
    EXPECT_NEAR(1.5 * std::hypot(bent->wi.x, bent->wi.y), std::hypot(wo.x, wo.y), 1e-12);
    // Presence: all of the surface is scaled, and what goes through goes straight.
    m.opacity_mode = PreviewOpacityMode::Presence;
    EXPECT_NEAR(delta_albedo(bsdf(m), wo, true).r, 0.75, 1e-3);
    EXPECT_NEAR(delta_albedo(bsdf(m), wo, false).r, 0.25 * highlight.r, 1e-3);
    const auto straight = pick(bsdf(m), wo, 0);
    ASSERT_TRUE(straight);
    EXPECT_EQ(straight->wi, -wo);
    // A threshold cuts out, in either mode.
    for (auto mode : {PreviewOpacityMode::Presence, PreviewOpacityMode::Transparent}) {
        m.opacity_mode = mode;
        m.opacity_threshold = 0.3;
        EXPECT_NEAR(delta_albedo(bsdf(m), wo, true).r, 1, 1e-12);
        m.opacity_threshold = 0.25;
        EXPECT_EQ(delta_albedo(bsdf(m), wo, true).r, 0);
    }
}

/// The second highlight has the material's ior, its own roughness, and takes light from what is below it.
TEST_F(MaterialTest, PreviewSurfaceClearcoat) {
    const Vec3 normal{0, 0, 1};
    PreviewSurfaceMaterial m;
    m.diffuse_color.value = {0, 0, 0};
    m.ior = 2;
    m.roughness.value = 0;
    m.clearcoat_roughness.value = 0;
    m.clearcoat.value = 0.75;
    const double f0 = 1.0 / 9;
    EXPECT_NEAR(delta_albedo(bsdf(m), normal, false).r, 0.75 * f0 + (1 - 0.75 * f0) * f0, 1e-3);
    m.metallic.value = 1;
    m.diffuse_color.value = {1, 0.5, 0};
    EXPECT_TRUE(is<Layered>(model(m)));
    const Rgb gold = delta_albedo(bsdf(m), normal, false);
    EXPECT_NEAR(gold.r, 1, 1e-12);
    EXPECT_NEAR(gold.b, 0.75 * f0, 1e-3);
    m.clearcoat_roughness.value = 0.5;
    EXPECT_NEAR(delta_albedo(bsdf(m), normal, false).b, 0, 1e-12);
    EXPECT_TRUE(bsdf(m).connectible());
    m.ior = 1;
    EXPECT_TRUE(is<Conductor>(model(m)));
}

/// coat_weight, coat_ior and coat_darkening: a black and a white mirror under a smooth coat.
TEST_F(MaterialTest, OpenPbrCoat) {
    const Vec3 normal{0, 0, 1};
    OpenPbrMaterial m;
    m.base_metalness.value = 1;
    m.base_color.value = {1, 0.5, 0};
    m.specular_roughness.value = 0;
    m.coat_weight.value = 0.5;
    m.coat_darkening.value = 0;
    const double f0 = std::pow(0.6 / 2.6, 2);
    const Rgb plain = delta_albedo(bsdf(m), normal, false);
    EXPECT_NEAR(plain.r, 1, 1e-12);
    EXPECT_NEAR(plain.g, 0.5 * f0 + (1 - 0.5 * f0) * 0.5, 1e-3);
    EXPECT_NEAR(plain.b, 0.5 * f0, 1e-3);
    m.coat_darkening.value = 1;
    const double k = 1 - (1 - f0) / (1.6 * 1.6);
    const double factor = 0.5 + 0.5 * (1 - k) / (1 - 0.5 * k);
    const Rgb dark = delta_albedo(bsdf(m), normal, false);
    EXPECT_NEAR(dark.r, 1, 1e-12);
    EXPECT_NEAR(dark.g, 0.5 * f0 + (1 - 0.5 * f0) * 0.5 * factor, 1e-3);
    m.coat_roughness.value = 0.5;
    EXPECT_TRUE(bsdf(m).connectible());
}

/// Clear glass has nothing to darken: whatever its base's colour, what the coat lets through leaves again.
TEST_F(MaterialTest, CoatedGlassLosesNothing) {
    OpenPbrMaterial m;
    m.transmission_weight.value = 1;
    m.specular_roughness.value = 0;
    m.coat_weight.value = 1;
    const Bsdf glass = bsdf(m);
    for (const Vec3& wo : {Vec3{0, 0, 1}, direction(0.5, 1)}) {
        double share = 0;
        constexpr int kTries = 10'000;
        for (int i = 0; i < kTries; ++i) {
            const auto sample = glass.sample(wo, (i + 0.5) / kTries, {0.5, 0.5}, TransportMode::Importance, kCorrect);
            share += sample ? sample->weight.g / kTries : 0;
        }
        EXPECT_NEAR(share, 1, 2e-3);
    }
}

/// A hole lets through what the normals disagree about.
TEST_F(MaterialTest, PresenceDoesNotDependOnNormals) {
    LayeredParameters p;
    p.presence = 0.5;
    p.coated = 1;
    p.diffuse = Rgb(1);
    const Bsdf bsdf = tilted(Layered(p));
    const Vec3 wo = direction(0.01, std::atan2(0.2, -0.35));
    ASSERT_LT(dot(wo, bsdf.n_s()), 0);
    const auto through = pick(bsdf, wo, 0.2);
    ASSERT_TRUE(through);
    EXPECT_EQ(through->wi, -wo);
    EXPECT_EQ(through->weight, Rgb(1));
    EXPECT_FALSE(pick(bsdf, wo, 0.8));
}

/// eta' = (1 + e) / (1 - e), e = sgn(eta - 1) sqrt(weight F0), in reflection, refraction and the squared index.
TEST_F(MaterialTest, SpecularWeightChangesTheIndexOfRefraction) {
    for (double ior : {1.5, 1 / 1.5}) {
        OpenPbrMaterial m;
        m.specular_ior = ior;
        m.specular_weight.value = 0.25;
        m.specular_roughness.value = 0;
        m.transmission_weight.value = 1;
        const double e = (ior > 1 ? 1 : -1) * 0.5 * std::abs((ior - 1) / (ior + 1));
        const double eta = (1 + e) / (1 - e);
        const Vec3 wo = direction(0.9, 1);
        const auto s = pick(bsdf(m), wo, 0.999);
        ASSERT_TRUE(s && s->transmission);
        EXPECT_NEAR(eta * std::hypot(s->wi.x, s->wi.y), std::hypot(wo.x, wo.y), 1e-12);
        EXPECT_NEAR(s->weight.r, 1 / (eta * eta), 1e-12);
        EXPECT_NEAR(s->radiance_scale, 1 / (eta * eta), 1e-12);
        EXPECT_NEAR(delta_albedo(bsdf(m), {0, 0, 1}, false).r, 0.25 * 0.04, 1e-3);
    }
}

/// A metal's Fresnel curve: base colour at normal incidence, tinted at cos = 1/7, all times specular_weight.
TEST_F(MaterialTest, OpenPbrMetal) {
    OpenPbrMaterial m;
    m.base_metalness.value = 1;
    m.base_weight.value = 0.5;
    m.base_color.value = {1, 0.5, 0.2};
    m.specular_color.value = {0.5, 1, 1};
    m.specular_weight.value = 0.8;
    m.specular_roughness.value = 0;
    const auto normal = pick(bsdf(m), {0, 0, 1}, 0.5);
    ASSERT_TRUE(normal);
    EXPECT_NEAR(normal->weight.r, 0.8 * 0.5, 1e-12);
    EXPECT_NEAR(normal->weight.g, 0.8 * 0.25, 1e-12);
    const auto at_82 = pick(bsdf(m), direction(1.0 / 7, 0), 0.5);
    ASSERT_TRUE(at_82);
    EXPECT_NEAR(at_82->weight.r, 0.8 * 0.5 * (0.5 + 0.5 * pow5(6.0 / 7)), 1e-12);
    EXPECT_NEAR(at_82->weight.g, 0.8 * (0.25 + 0.75 * pow5(6.0 / 7)), 1e-12);
}

/// The coat's curve has the mean reflectance of the exact interface, and goes away with it.
TEST_F(MaterialTest, OpenPbrCoatHasTheMeanOfTheExactFresnelCurve) {
    for (double ior : {1.01, 1.1, 1.3, 1.5}) {
        OpenPbrMaterial m;
        m.specular_ior = ior;
        m.specular_roughness.value = 0;
        m.base_color.value = {0, 0, 0};
        double coat = 0;
        double exact = 0;
        constexpr int kN = 1000;
        for (int i = 0; i < kN; ++i) {
            const double cos = (i + 0.5) / kN;
            const auto s = pick(bsdf(m), direction(cos, 0), 0.5);
            ASSERT_TRUE(s && s->delta);
            coat += 2 * cos * s->weight.r / kN;
            exact += 2 * cos * fresnel_dielectric(cos, ior) / kN;
        }
        EXPECT_NEAR(coat / exact, 1, ior < 1.35 ? 1e-3 : 0.07)
            << ior;  // near 1.5 the grazing reflectance is capped at 1
    }
}

TEST_F(MaterialTest, TexturesReplaceConstants) {
    DiffuseMaterial m;
    m.reflectance.texture = add_texture({0.2, 0.4, 0.6, 1});
    const Vec3 w = direction(0.5, 0);
    const Rgb f = bsdf(m).eval_cos(w, w, TransportMode::Radiance, kCorrect);
    EXPECT_NEAR(f.r, 0.2 * 0.5 * kInvPi, 1e-12);
    EXPECT_NEAR(f.b, 0.6 * 0.5 * kInvPi, 1e-12);
    ConductorMaterial metal;
    metal.roughness.texture = add_texture({0, 0, 0.3, 1});
    metal.roughness.channel = 2;
    EXPECT_NEAR(bsdf(metal).pdf(w, w), flat(Conductor(Rgb(0.9), 0.09)).pdf(w, w), 1e-12);
}

TEST_F(MaterialTest, ValuesThatMakeNoSenseAreBroughtIntoRange) {
    const Vec3 w = direction(0.5, 0);
    for (const MaterialModel& m :
         {MaterialModel(DiffuseMaterial{{{kNan, 7, -3}}}), MaterialModel(ConductorMaterial{{{kNan, 7, -3}}, {kNan}}),
          MaterialModel(DielectricMaterial{kNan, {-2}, {{9, 9, 9}}, {{9, kNan, 9}}}),
          MaterialModel(DielectricMaterial{0, {9}}), MaterialModel(DielectricMaterial{-1.5, {9}})}) {
        const Bsdf b = bsdf(m);
        EXPECT_LE(max_component(b.eval_cos(w, w, TransportMode::Radiance, kCorrect)), 100);
        for (double u : {0.1, 0.9}) {
            const auto s = pick(b, w, u);
            if (!s) continue;
            EXPECT_LE(max_component(s->weight), 1 + 1e-12);
            EXPECT_TRUE(is_finite(s->wi));
        }
    }
}

/// The texel's x goes along s, its y along t, whichever way t runs.
TEST_F(MaterialTest, NormalMapTiltsTheShadingNormal) {
    MaterialDesc material;
    material.model = DiffuseMaterial{};
    material.normal_texture = add_texture({0.6, 0, 0.8, 1});
    const int along_t = add_texture({0, 0.6, 0.8, 1});
    const int nothing = add_texture({0, 0, 0, 1});
    const int backwards = add_texture({0, 0.6, -0.8, 1});
    const int twice = add_texture({1.2, 0, 1.6, 1});
    const TextureSet set = textures();
    const auto normal = [&](int texture, const SurfaceInteraction& si) {
        material.normal_texture = texture;
        return make_bsdf(material, set, si).n_s();
    };
    const auto expect_near = [](const Vec3& a, const Vec3& b) { EXPECT_LT(length(a - b), 1e-12) << a.x << a.y << a.z; };
    SurfaceInteraction si = surface();
    expect_near(normal(0, si), {0.6, 0, 0.8});
    expect_near(normal(twice, si), {0.6, 0, 0.8});
    expect_near(normal(along_t, si), {0, 0.6, 0.8});
    si.dpdt = {1, -3, 0};  // mirrored, and not at right angles
    expect_near(normal(along_t, si), {0, -0.6, 0.8});
    si.dpds = {5, 0, 7};  // not in the tangent plane of n_s
    expect_near(normal(0, si), {0.6, 0, 0.8});
    expect_near(normal(nothing, si), {0, 0, 1});
    for (const Vec3& useless : {Vec3{}, Vec3{0, 0, 2}, Vec3{kNan, 0, 0}}) {
        si.dpds = useless;
        expect_near(normal(0, si), {0, 0, 1});
    }
    // Facing away is legal, and black.
    si = surface();
    expect_near(normal(backwards, si), {0, 0.6, -0.8});
    const Bsdf away = make_bsdf(material, set, si);
    EXPECT_FALSE(pick(away, {0, 0, 1}, 0.5));
    EXPECT_EQ(away.pdf({0, 0, 1}, {0, 0, 1}), 0);
}

TEST_F(MaterialTest, EmissionIsUnboundedAboveAndNeverNegative) {
    MaterialDesc m;
    m.emission.value = {1000, -1, kNan};
    EXPECT_EQ(material_emission(m, textures(), {}), Rgb(1000, 0, 0));
}

TEST_F(MaterialTest, AlbedoIsDiffusePlusSpecularColor) {
    const auto albedo_of = [&](const MaterialModel& model) {
        MaterialDesc m;
        m.model = model;
        return material_albedo(m, textures(), {});
    };
    EXPECT_EQ(albedo_of(DiffuseMaterial{{{0.1, 0.2, 0.3}}}), Rgb(0.1, 0.2, 0.3));
    PreviewSurfaceMaterial plastic;
    plastic.diffuse_color.value = {0.5, 0.5, 0.5};
    EXPECT_NEAR(albedo_of(plastic).r, 0.04 + 0.96 * 0.5, 1e-12);
    OpenPbrMaterial gold;
    gold.base_metalness.value = 1;
    gold.base_color.value = {1, 0.8, 0.3};
    EXPECT_NEAR(albedo_of(gold).b, 0.3, 1e-12);
}

}  // namespace
}  // namespace etendue::test
