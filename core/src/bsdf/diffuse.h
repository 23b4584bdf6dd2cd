#pragma once

#include <cmath>
#include <optional>

#include "bsdf/adjoint.h"
#include "bsdf/bsdf_sample.h"
#include "math/constants.h"
#include "math/sampling.h"

namespace etendue {

/// Lambert, on whichever side wo is.
class Diffuse {
public:
    explicit Diffuse(const Rgb& reflectance) : reflectance_(reflectance) {}

    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi, TransportMode, const AdjointPolicy&) const {
        return wo.z * wi.z > 0 ? reflectance_ * kInvPi : Rgb();
    }

    [[nodiscard]] double pdf(const Vec3& wo, const Vec3& wi) const {
        return wo.z * wi.z > 0 ? std::abs(wi.z) * kInvPi : 0;
    }

    [[nodiscard]] std::optional<BsdfSample> sample(const Vec3& wo, double, const Vec2& u, TransportMode,
                                                   const AdjointPolicy&) const {
        Vec3 wi = sample_cosine_hemisphere(u);
        wi.z = std::copysign(wi.z, wo.z);
        if (!(wo.z * wi.z > 0) || is_black(reflectance_)) return std::nullopt;
        BsdfSample sample;
        sample.wi = wi;
        sample.weight = reflectance_;
        sample.pdf_fwd = pdf(wo, wi);
        sample.pdf_rev = pdf(wi, wo);
        return sample;
    }

    [[nodiscard]] bool has_delta() const { return false; }
    [[nodiscard]] bool has_non_delta() const { return true; }

private:
    Rgb reflectance_;
};

}  // namespace etendue
