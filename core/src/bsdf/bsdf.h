#pragma once

#include <concepts>
#include <optional>

#include <etendue/render_settings.h>

#include "bsdf/adjoint.h"
#include "bsdf/bsdf_model.h"
#include "bsdf/bsdf_sample.h"
#include "bsdf/transport_mode.h"
#include "math/frame.h"

namespace etendue {

/// A BSDF at a point: a local model, its shading frame and the geometric normal, which together make fbar of
/// theory.md §6. wo is the known direction (towards the previous vertex), wi the sampled one; both point away.
class Bsdf {
public:
    Bsdf(const BsdfModel& model, const Frame& shading_frame, const Vec3& n_g)
        : model_(model), frame_(shading_frame), n_g_(n_g) {}
    /// Of the model that `make` returns, built in place: a copy would move as many bytes as the largest model has, for
    /// the plainest one too.
    template <std::invocable MakeModel>
    Bsdf(const MakeModel& make, const Frame& shading_frame, const Vec3& n_g)
        : model_(make()), frame_(shading_frame), n_g_(n_g) {}

    /// fbar |wi . n_g|: what a connection or next-event estimate multiplies, with 1/d^2 and the other end's cosine left
    /// to the caller. The cosine is kept inside because fbar alone has a pole where the product has none.
    [[nodiscard]] Rgb eval_cos(const Vec3& wo, const Vec3& wi, TransportMode mode, const AdjointPolicy& policy) const;

    /// Density of sampling wi given wo, per solid angle; non-delta lobes.
    [[nodiscard]] double pdf(const Vec3& wo, const Vec3& wi) const;

    /// Empty when the sample carries nothing.
    [[nodiscard]] std::optional<BsdfSample> sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode mode,
                                                   const AdjointPolicy& policy) const;

    /// False when every lobe is a delta: no connection can be made here.
    [[nodiscard]] bool connectible() const;

    [[nodiscard]] const Vec3& n_s() const { return frame_.n; }

private:
    BsdfModel model_;
    Frame frame_;
    Vec3 n_g_;
};

}  // namespace etendue
