#include "scene/media_probe.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "math/frame.h"
#include "math/rng.h"
#include "math/sampling.h"

namespace etendue {
namespace {

class MediaProbe {
public:
    explicit MediaProbe(const Scene& scene) : scene_(scene) {}

    void follow(Ray ray, Rng& rng) {
        constexpr int kMostSurfaces = 24;  // who is walled in farther from every transparent body may count as outside
        std::set<MediumId> met;
        double travelled = 0;
        std::size_t scattered = 0;
        for (int i = 0; i < kMostSurfaces; ++i) {
            const auto si = scene_.intersect(ray);
            if (!si) return;
            const bool from_inside = dot(ray.direction, si->n_g) > 0;
            travelled += length(si->p - ray.origin);
            if (const MediumId id = scene_.absorption().medium(*si); id == 0) {
                scattered = 1;
                const Frame frame = Frame::from_normal(from_inside ? -si->n_g : si->n_g);
                ray.direction = frame.to_world(sample_cosine_hemisphere(rng.next_2d()));
            } else if (met.insert(id).second) {
                Votes& votes = votes_[id];
                votes.inside[scattered] += from_inside ? 1 : -1;
                if (from_inside) votes.nearest = std::min(votes.nearest, travelled);
            }
            ray.origin = offset_origin(si->p, si->p_error, si->n_g, ray.direction);
        }
    }

    [[nodiscard]] Media verdict() const {
        std::vector<std::pair<double, MediumId>> bodies;
        for (const auto& [id, votes] : votes_) {
            const int inside = votes.inside[0] != 0 ? votes.inside[0] : votes.inside[1];
            if (inside > 0) bodies.emplace_back(votes.nearest, id);
        }
        std::sort(bodies.rbegin(), bodies.rend());
        Media media;
        for (const auto& [distance, id] : bodies) media.enter(id);
        return media;
    }

private:
    struct Votes {
        std::array<int, 2> inside{};  ///< inside less outside: directly, and after scattering
        double nearest = kInfinity;   ///< length of the way to the surface: the innermost body's is met first
    };

    const Scene& scene_;
    std::map<MediumId, Votes> votes_;
};

}  // namespace

Media media_at(const Scene& scene, const Vec3& p) {
    if (!scene.absorbs()) return {};
    constexpr int kRays = 64;
    MediaProbe probe(scene);
    Rng rng(0, 0, 0);
    for (int i = 0; i < kRays; ++i) {
        const Vec3 w = sample_uniform_sphere(rng.next_2d());
        probe.follow({offset_origin(p, {}, {}, w), w}, rng);
    }
    return probe.verdict();
}

Media media_before(const Scene& scene, const Light& light) {
    if (!scene.absorbs() || light.infinite() || is_black(light.power())) return {};
    constexpr int kRays = 16;
    MediaProbe probe(scene);
    Rng rng(0, 0, 0);
    for (int i = 0; i < kRays; ++i) {
        const Vec2 u_point = rng.next_2d();
        const EmissionSample ray = light.sample_emission(u_point, rng.next_2d());
        probe.follow({offset_origin(ray.origin, ray.y.p_error, ray.y.n, ray.direction), ray.direction}, rng);
    }
    return probe.verdict();
}

}  // namespace etendue
