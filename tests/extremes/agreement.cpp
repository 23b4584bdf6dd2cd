#include "extremes/agreement.h"

#include <cmath>

#include "math/constants.h"

namespace etendue::test {

double errors_apart(const Replicas& a, const Replicas& b) {
    if (a.invalid + b.invalid > 0) return kInfinity;
    if (a.mean() == b.mean()) return 0;
    return std::abs(a.mean() - b.mean()) / std::hypot(a.standard_error(), b.standard_error());
}

double relative_error(const Replicas& seen, double expected) {
    return seen.invalid > 0 ? kInfinity : std::abs(seen.mean() / expected - 1);
}

Replicas replicas(const SceneDescription& scene, IntegratorKind integrator, int samples_per_pixel) {
    const bool path = integrator == IntegratorKind::Path;
    const RenderSettings settings = small_settings(integrator, 8, samples_per_pixel * (path ? 4 : 1));
    return render_replicas(scene, settings, kReplicas, 1 + static_cast<std::uint64_t>(integrator));
}

}  // namespace etendue::test
