#include "light/beam.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/constants.h"
#include "math/sampling.h"

namespace etendue {
namespace {

/// Whether unit vectors differ by more than the roundings of a transform: below, the side to which one leans is noise,
/// and another on every scale.
bool leans(const Vec3& axis, const Vec3& front) { return length(cross(axis, front)) > 0x1p-44; }

/// n is the axis; s is on the side to which `front` leans, so that rings are summed up from there.
Frame leaning_frame(const Vec3& axis, const Vec3& front) {
    if (!leans(axis, front)) return Frame::from_normal(axis);
    // Of two vectors that differ by little the product is not quite perpendicular: make it so again.
    const Vec3 s = normalize(cross(normalize(cross(axis, front)), axis));
    return {s, cross(axis, s), axis};
}

double versed(double theta) {
    const double s = std::sin(theta / 2);
    return 2 * s * s;
}

/// Mean over a ring.
double mean_silhouette(const Frame& frame, double theta, const Beam::Silhouette& silhouette) {
    constexpr int kAzimuths = 32;
    double sum = 0;
    for (int i = 0; i < kAzimuths; ++i) {
        const double phi = 2 * kPi * i / kAzimuths;
        sum += silhouette(
            frame.to_world({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}));
    }
    return sum / kAzimuths;
}

struct Node {
    double x;
    double weight;
};
/// Gauss and Legendre's rule on [0, 1].
constexpr std::array<Node, 3> kNodes{{{0.1127016653792583, 5 / 18.0}, {0.5, 8 / 18.0}, {0.8872983346207417, 5 / 18.0}}};

}  // namespace

Beam::Beam(const Shaping& shaping, const Vec3& front, const Silhouette& silhouette)
    : shaping_(shaping), frame_(leaning_frame(shaping.axis(), front)) {
    const std::vector<double> thetas = shaping.rings();
    std::vector<double> weights;
    double sum = 0;
    double sum_squares = 0;
    for (std::size_t ring = 0; ring + 1 < thetas.size(); ++ring) {
        const double width = thetas[ring + 1] - thetas[ring];
        Rgb power;
        for (const Node& node : kNodes) {
            const double theta = thetas[ring] + width * node.x;
            const double solid_angle = 2 * kPi * std::sin(theta) * width * node.weight;
            const Rgb factor = shaping.factor(theta);
            power += factor * (solid_angle * mean_silhouette(frame_, theta, silhouette));
            sum += total(factor) * solid_angle;
            sum_squares += total(factor) * total(factor) * solid_angle;
        }
        weights.push_back(total(power));
        integral_ += power;
    }
    // The edge of a flat light that leans may pass between the azimuths of a ring: leave none without a chance.
    if (leans(shaping.axis(), front) && !weights.empty()) {
        const double least = 1e-3 * total(integral_) / static_cast<double>(weights.size());
        for (double& weight : weights) weight += least;
    }
    for (const double theta : thetas) edges_.push_back(versed(theta));
    rings_ = Distribution(weights);
    if (sum > 0) concentration_ = 4 * kPi * sum_squares / (sum * sum);
}

double Beam::ring_pdf(std::size_t ring) const {
    return rings_.pmf(ring) / (2 * kPi * (edges_[ring + 1] - edges_[ring]));
}

Vec3 Beam::sample(const Vec2& u) const {
    const Distribution::Sample ring = rings_.sample(u.x);
    const double v = edges_[ring.index] + (edges_[ring.index + 1] - edges_[ring.index]) * ring.u;
    const double sin = std::sqrt(std::max(0.0, v * (2 - v)));
    const double phi = 2 * kPi * u.y;
    return frame_.to_world({sin * std::cos(phi), sin * std::sin(phi), 1 - v});
}

double Beam::pdf(const Vec3& w) const {
    const double v = length_squared(w - frame_.n) / 2;
    const auto above = std::upper_bound(edges_.begin(), edges_.end(), v);
    if (above == edges_.end()) return v <= edges_.back() ? ring_pdf(edges_.size() - 2) : 0;
    return ring_pdf(static_cast<std::size_t>(above - edges_.begin()) - 1);
}

LightBounds narrowed(LightBounds bounds, const Beam& beam) {
    if (beam.end() >= kPi / 2) return bounds;
    bounds.axis = beam.axis();
    bounds.cos_normals = 1;
    bounds.cos_emission = std::cos(beam.end());
    return bounds;
}

}  // namespace etendue
