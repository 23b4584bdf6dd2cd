// The weight that each strategy gives a path that it really made, against the oracle on densities computed anew from
// the path's vertices. As the oracle's weights of one path add up to one, so do these.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "integrator/bdpt/connection.h"
#include "integrator/bdpt/subpath.h"
#include "integrator/needed_draws.h"
#include "support/path_oracle.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

struct Case {
    const char* name;
    SceneDescription (*scene)();
};

/// Traces subpaths and checks all that can be made of them.
class Checker {
public:
    Checker(const SceneDescription& description, MisHeuristic heuristic)
        : settings_(make_settings(heuristic)),
          camera_(description.cameras[0], settings_.width, settings_.height, settings_.conform),
          scene_(description, {camera_.position()}),
          context_{scene_, camera_, settings_, Filter(settings_.filter), {0, 0, 16, 16}, {}, false, false},
          active_{true, true, true, true, camera_.has_lens(), 256},
          tracer_(context_, active_),
          connector_(context_, active_) {}

    void run(int paths) {
        for (int i = 0; i < paths; ++i) {
            sampler_.emplace(SampleIndex{7, 0, static_cast<std::uint64_t>(i), 0});
            const Vec2 u = sampler_->next_2d();
            tracer_.trace_camera({16 * u.x, 16 * u.y}, *sampler_, eye_, rays_);
            tracer_.trace_light(*sampler_, light_, rays_);
            check_emission();
            check_escape();
            check_crossings();
            for (std::size_t j = 0; j < light_.vertices.size(); ++j) check_light_image(j);
            if (light_.start) check_start_image();
            for (std::size_t e = 0; e < eye_.vertices.size(); ++e) {
                if (!eye_.vertices[e].connectible()) continue;
                check_direct(e);
                for (std::size_t j = 0; j < light_.vertices.size(); ++j) check_connection(j, e);
            }
        }
    }

    int checked = 0;
    int unseen = 0;  ///< paths that find the lens from where no pixel looks
    std::vector<double> tolerances;

private:
    static RenderSettings make_settings(MisHeuristic heuristic) {
        RenderSettings settings;
        settings.width = settings.height = 16;
        settings.heuristic = heuristic;
        settings.max_depth = 6;
        settings.roulette_depth = -1;
        return settings;
    }

    static PathVertex vertex(const Vertex& v, bool delta) {
        return {v.si.p, v.si.n_g, v.bsdf ? &*v.bsdf : nullptr, delta};
    }
    /// y1 ... y_last, which is joined to something.
    void add_light_side(std::size_t last, WholePath& path) const {
        for (std::size_t i = 0; i <= last; ++i) {
            path.surfaces.push_back(vertex(light_.vertices[i], i < last && light_.vertices[i + 1].mis.connect == 0));
        }
    }
    /// z_last ... z1; `delta_last` when z_last itself went on by a delta lobe.
    void add_eye_side(std::size_t count, bool delta_last, WholePath& path) const {
        for (std::size_t i = count; i-- > 0;) {
            const bool last = i + 1 == count;
            path.surfaces.push_back(
                vertex(eye_.vertices[i], last ? delta_last : eye_.vertices[i + 1].mis.connect == 0));
        }
        path.lens = eye_.origin;
    }

    void expect(const WholePath& path, std::size_t s, double weight) {
        const std::vector<double> oracle = oracle_weights(path_densities(path, context_), active_, settings_.heuristic);
        const double allowed = kAmplification * rounding(path);
        tolerances.push_back(allowed);
        EXPECT_NEAR(weight, oracle[s], allowed) << "s = " << s << ", t = " << oracle.size() - 1 - s;
        ++checked;
    }

    /// The walk's directions were sampled, the oracle's run between vertices; ray offsets and Embree's float keep them
    /// apart by an angle of some float roundings of the scene's size (about 4) over each edge's length, and a density
    /// per area feels an angle as much as the edge is grazing.
    [[nodiscard]] double rounding(const WholePath& path) const {
        constexpr double kPositionError = 4 * 0x1p-21;
        double sum = 0x1p-22;
        const auto add = [&sum](const Vec3& a, const Vec3& n_a, const Vec3& b, const Vec3& n_b) {
            const Vec3 d = b - a;
            const double cos = std::min(abs_dot(d, n_a), abs_dot(d, n_b)) / length(d);
            sum += (kPositionError / length(d) + 0x1p-22) / cos;
        };
        for (std::size_t i = 0; i + 1 < path.surfaces.size(); ++i) {
            add(path.surfaces[i].p, path.surfaces[i].n_g, path.surfaces[i + 1].p, path.surfaces[i + 1].n_g);
        }
        if (path.surfaces.empty()) return sum;
        const PathVertex& first = path.surfaces.front();
        if (!scene_.light(path.light).infinite()) add(path.y.p, first.n_g, first.p, first.n_g);
        const PathVertex& last = path.surfaces.back();
        add(last.p, last.n_g, path.lens, last.n_g);
        return sum;
    }
    /// Of an angle by the narrowest lobes (alpha = 0.16) and by the curvature of the spheres.
    static constexpr double kAmplification = 3;

    [[nodiscard]] static LightPoint light_point(const SurfaceInteraction& si) {
        return {si.p, si.n_g, si.st, si.p_error};
    }

    void check_emission() {
        for (std::size_t i = 0; i < eye_.vertices.size(); ++i) {
            const auto c = connector_.emission(eye_, i);
            if (!c) continue;
            const Vertex& z = eye_.vertices[i];
            WholePath path{z.si.light, light_point(z.si), {}, {}};
            add_eye_side(i, z.mis.connect == 0, path);
            expect(path, 0, c->weight);
        }
    }
    void check_escape() {
        if (!eye_.escape) return;
        for (int index : scene_.infinite_lights()) {
            const auto c = connector_.infinite_emission(*eye_.escape, index);
            if (!c) continue;
            const Vec3& w = eye_.escape->direction;
            WholePath path{index, {w, -w, {}, {}}, {}, {}};
            add_eye_side(eye_.vertices.size(), eye_.escape->mis.connect == 0, path);
            expect(path, 0, c->weight);
        }
    }
    void check_direct(std::size_t e) {
        Sampler copy = *sampler_;  // draws what the connector draws
        const Vertex& z = eye_.vertices[e];
        const auto c = connector_.direct(z, *sampler_, rays_);
        const auto choice = scene_.light_sampler().sample_direct(z.si.p, draw_light(context_, copy));
        const Vec2 u = copy.next_2d();
        if (!c) return;
        const auto sample = scene_.light(choice->light).sample_direct(z.si.p, u);
        WholePath path{choice->light, sample->y, {}, {}};
        add_eye_side(e + 1, false, path);
        expect(path, 1, c->weight);
    }
    void check_connection(std::size_t j, std::size_t e) {
        if (!light_.vertices[j].connectible()) return;
        const auto c = connector_.connect(light_.vertices[j], eye_.vertices[e], rays_);
        if (!c) return;
        WholePath path{light_.start->light, light_.start->y, {}, {}};
        add_light_side(j, path);
        add_eye_side(e + 1, false, path);
        expect(path, j + 2, c->weight);
    }
    void check_light_image(std::size_t j) {
        const Vertex& y = light_.vertices[j];
        if (!y.connectible()) return;
        Sampler copy = *sampler_;
        const auto c = connector_.to_lens(y, *sampler_, rays_);
        if (!c) return;
        WholePath path{light_.start->light, light_.start->y, {}, {}};
        add_light_side(j, path);
        path.lens = camera_.sample_lens(y.si.p, draw_lens(context_, copy))->origin;
        expect(path, j + 2, c->weight);
    }
    void check_start_image() {
        Sampler copy = *sampler_;
        const auto c = connector_.start_to_lens(*light_.start, *sampler_, rays_);
        if (!c) return;
        const Vec2 u = draw_lens(context_, copy);
        const Vec3& p = light_.start->y.p;
        const bool infinite = scene_.light(light_.start->light).infinite();
        WholePath path{light_.start->light, light_.start->y, {}, {}};
        path.lens = (infinite ? camera_.sample_lens_towards(p, u) : camera_.sample_lens(p, u))->origin;
        expect(path, 1, c->weight);
    }
    void check_crossings() {
        for (const LensCrossing& crossing : light_.crossings) {
            WholePath path{light_.start->light, light_.start->y, {}, crossing.hit.p};
            const auto surfaces = static_cast<std::size_t>(crossing.s) - 2;
            for (std::size_t i = 0; i < surfaces; ++i) {
                const MisState& next = i + 1 < surfaces ? light_.vertices[i + 1].mis : crossing.mis;
                path.surfaces.push_back(vertex(light_.vertices[i], next.connect == 0));
            }
            const auto c = connector_.lens_hit(crossing);
            const Vec2& raster = crossing.hit.raster;
            const bool seen = raster.x >= 0 && raster.x < 16 && raster.y >= 0 && raster.y < 16;
            EXPECT_EQ(c.has_value(), seen) << raster.x << ' ' << raster.y;
            unseen += seen ? 0 : 1;
            if (c) expect(path, surfaces + 2, c->weight);
        }
    }

    RenderSettings settings_;
    Camera camera_;
    Scene scene_;
    RenderContext context_;
    ActiveStrategies active_;
    SubpathTracer tracer_;
    Connector connector_;
    std::optional<Sampler> sampler_;
    CameraSubpath eye_;
    LightSubpath light_;
    std::uint64_t rays_ = 0;
};

class RealPaths : public testing::TestWithParam<Case> {};

TEST_P(RealPaths, WeightsEqualTheOracle) {
    const SceneDescription scene = GetParam().scene();
    for (const MisHeuristic heuristic : {MisHeuristic::Balance, MisHeuristic::Power}) {
        Checker checker(scene, heuristic);
        checker.run(900);
        EXPECT_GT(checker.checked, 1000);
        if (GetParam().scene == lens_box) EXPECT_GT(checker.unseen, 0);
        // Paths in corners are allowed more; most must be held closely, or nothing was shown.
        std::nth_element(checker.tolerances.begin(), checker.tolerances.begin() + checker.checked / 2,
                         checker.tolerances.end());
        EXPECT_LT(checker.tolerances[static_cast<std::size_t>(checker.checked) / 2], 1e-4);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RealPaths,
                         testing::Values(Case{"diffuse_box", diffuse_box}, Case{"glossy_box", glossy_box},
                                         Case{"glass_box", glass_box}, Case{"rough_glass_box", rough_glass_box},
                                         Case{"mirror_box", mirror_box}, Case{"smooth_normals_box", smooth_normals_box},
                                         Case{"sky", sky}, Case{"many_lights", many_lights},
                                         Case{"aimed_lights", aimed_lights}, Case{"light_crowd", light_crowd},
                                         Case{"delta_lights", delta_lights}, Case{"lens_box", lens_box},
                                         Case{"orthographic_box", orthographic_box},
                                         Case{"orthographic_sky", orthographic_sky},
                                         Case{"instanced_box", instanced_box}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace etendue::test
