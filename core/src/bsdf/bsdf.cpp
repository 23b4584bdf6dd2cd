#include "bsdf/bsdf.h"

#include <cmath>

namespace etendue {
namespace {

/// Directions that n_s and n_g put on different sides carry nothing (theory.md §6). Nor do those in either tangent
/// plane: a cosine this small has no digit right, and the shading-normal factor would overflow.
bool consistent(double cos_ns, double cos_ng) {
    constexpr double kTangent = 1e-100;
    return (cos_ns > kTangent && cos_ng > kTangent) || (cos_ns < -kTangent && cos_ng < -kTangent);
}

}  // namespace

Rgb Bsdf::eval_cos(const Vec3& wo, const Vec3& wi, TransportMode mode, const AdjointPolicy& policy) const {
    const Vec3 wo_local = frame_.to_local(wo);
    const Vec3 wi_local = frame_.to_local(wi);
    const double cos_wo_ng = dot(wo, n_g_);
    const double cos_wi_ng = dot(wi, n_g_);
    if (!consistent(wo_local.z, cos_wo_ng) || !consistent(wi_local.z, cos_wi_ng)) return Rgb();
    const Rgb f = std::visit([&](const auto& model) { return model.eval(wo_local, wi_local, mode, policy); }, model_);
    const double cos_wi_ns = std::abs(wi_local.z);
    return f * (cos_wi_ns * shading_normal_factor(mode, std::abs(cos_wo_ng), std::abs(wo_local.z), std::abs(cos_wi_ng),
                                                  cos_wi_ns, policy));
}

double Bsdf::pdf(const Vec3& wo, const Vec3& wi) const {
    const Vec3 wo_local = frame_.to_local(wo);
    const Vec3 wi_local = frame_.to_local(wi);
    if (!consistent(wo_local.z, dot(wo, n_g_)) || !consistent(wi_local.z, dot(wi, n_g_))) return 0;
    return std::visit([&](const auto& model) { return model.pdf(wo_local, wi_local); }, model_);
}

std::optional<BsdfSample> Bsdf::sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode mode,
                                       const AdjointPolicy& policy) const {
    const Vec3 wo_local = frame_.to_local(wo);
    std::optional<BsdfSample> sample =
        std::visit([&](const auto& model) { return model.sample(wo_local, u_lobe, u, mode, policy); }, model_);
    if (!sample || is_black(sample->weight)) return std::nullopt;

    if (sample->delta && sample->wi == -wo_local) {  // no surface there at all: normals have no say
        sample->wi = -wo;
        return sample;
    }
    const Vec3 wi_local = sample->wi;
    sample->wi = frame_.to_world(wi_local);
    const double cos_wo_ng = dot(wo, n_g_);
    const double cos_wi_ng = dot(sample->wi, n_g_);
    if (!consistent(wo_local.z, cos_wo_ng) || !consistent(wi_local.z, cos_wi_ng)) return std::nullopt;
    sample->weight *= shading_normal_factor(mode, std::abs(cos_wo_ng), std::abs(wo_local.z), std::abs(cos_wi_ng),
                                            std::abs(wi_local.z), policy);
    return sample;
}

bool Bsdf::connectible() const {
    return std::visit([](const auto& model) { return model.has_non_delta(); }, model_);
}

}  // namespace etendue
