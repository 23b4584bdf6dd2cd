#include "film/filter.h"

#include <cmath>

#include <etendue/error.h>

#include "math/constants.h"

namespace etendue {
namespace {

constexpr double kGaussianExtent = 4.5;  // radius^2 / (2 sigma^2) with sigma = radius / 3

/// Inverse of the triangle's cumulative distribution on [-1, 1].
double sample_triangle(double u) { return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u)); }

}  // namespace

Filter::Filter(const PixelFilter& filter) : kind_(filter.kind), radius_(filter.radius) {
    if (!(radius_ > 0) || !std::isfinite(radius_)) throw SettingsError("filter radius must be positive");
}

Vec2 Filter::sample(const Vec2& u) const {
    switch (kind_) {
        case FilterKind::Box:
            break;
        case FilterKind::Triangle:
            return {radius_ * sample_triangle(u.x), radius_ * sample_triangle(u.y)};
        case FilterKind::Gaussian: {
            // Inverts the radial distribution 1 - exp(-r^2 / (2 sigma^2)), cut at the radius.
            const double r = radius_ * std::sqrt(-std::log1p(u.x * std::expm1(-kGaussianExtent)) / kGaussianExtent);
            return {r * std::cos(2 * kPi * u.y), r * std::sin(2 * kPi * u.y)};
        }
    }
    return {radius_ * (2 * u.x - 1), radius_ * (2 * u.y - 1)};
}

double Filter::eval(const Vec2& offset) const {
    const double x = std::abs(offset.x) / radius_;
    const double y = std::abs(offset.y) / radius_;
    if (x > 1 || y > 1) return 0;
    const double per_area = 1 / (radius_ * radius_);
    switch (kind_) {
        case FilterKind::Box:
            break;
        case FilterKind::Triangle:
            return (1 - x) * (1 - y) * per_area;
        case FilterKind::Gaussian: {
            const double r2 = x * x + y * y;
            if (r2 > 1) return 0;
            return kGaussianExtent / (kPi * -std::expm1(-kGaussianExtent)) * std::exp(-kGaussianExtent * r2) * per_area;
        }
    }
    return per_area / 4;
}

}  // namespace etendue
