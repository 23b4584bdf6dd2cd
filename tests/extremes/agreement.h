#pragma once

#include "support/replicas.h"

namespace etendue::test {

/// By how many standard errors the means of two sets of renders differ. With 16 renders each a right renderer exceeds
/// kMostErrors once in a million.
[[nodiscard]] double errors_apart(const Replicas& a, const Replicas& b);
inline constexpr double kMostErrors = 6.1;

/// Of the mean from a known value. Infinite when a contribution was invalid.
[[nodiscard]] double relative_error(const Replicas& seen, double expected);

inline constexpr int kReplicas = 16;

/// Renders of a few pixels; path takes four times the samples of the others, which costs as much.
[[nodiscard]] Replicas replicas(const SceneDescription& scene, IntegratorKind integrator, int samples_per_pixel = 16);

}  // namespace etendue::test
