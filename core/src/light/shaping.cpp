#include "light/shaping.h"

#include <algorithm>
#include <cmath>

#include "light/usd_lux.h"
#include "math/constants.h"

namespace etendue {
namespace {

constexpr int kRings = 64;

void add_even(std::vector<double>& edges, double low, double high) {
    for (int i = 0; i <= kRings; ++i) edges.push_back(low + (high - low) * i / kRings);
}

}  // namespace

Rgb Shaping::factor(double theta) const { return lux_shaping(desc_, theta); }

// By the half angle: exact for the narrowest beams.
Rgb Shaping::factor(const Vec3& w) const { return factor(2 * std::atan2(length(w - axis_), length(w + axis_))); }

double Shaping::end() const { return lux_shaping_end(desc_); }

std::vector<double> Shaping::rings() const {
    std::vector<double> edges;
    add_even(edges, 0, end());
    if (end() > kPi / 2) edges.push_back(kPi / 2);  // where flat lights end
    // Steps of the cosine's power: it has fallen to e^-18 at six of its own widths.
    if (const double lobe = 6 / std::sqrt(std::max(desc_.focus, 1.0)); lobe < end()) {
        add_even(edges, 0, lobe);
        if (end() > kPi - lobe) add_even(edges, kPi - lobe, end());
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

}  // namespace etendue
