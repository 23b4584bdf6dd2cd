#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <etendue/film_view.h>
#include <etendue/render_settings.h>
#include <etendue/scene_description.h>

namespace etendue::test {

struct NamedScene {
    const char* name;
    SceneDescription scene;
};

/// One of each kind of shape, light, lens and transport.
[[nodiscard]] const std::vector<NamedScene>& all_kinds_of_scenes();

inline constexpr IntegratorKind kIntegrators[]{IntegratorKind::Path, IntegratorKind::Light, IntegratorKind::Bdpt};

struct NamedIntegrator {
    IntegratorKind kind;
    const char* name;
};
inline constexpr NamedIntegrator kNamedIntegrators[]{
    {IntegratorKind::Path, "path"}, {IntegratorKind::Light, "light"}, {IntegratorKind::Bdpt, "bdpt"}};

/// A few pixels and samples: for comparisons of pictures of one seed, sample by sample.
[[nodiscard]] RenderSettings quick_settings(IntegratorKind integrator);

struct Picture {
    std::vector<float> rgb;
    std::uint64_t invalid = 0;

    [[nodiscard]] double mean() const;
};

[[nodiscard]] Picture picture(const SceneDescription& scene, const RenderSettings& settings);

struct Worst {
    double figure = 0;
    std::string where = "all scenes";
};

/// The largest figure that `measure` finds in any of these scenes with any integrator.
[[nodiscard]] Worst worst_of_all(
    const std::function<double(const SceneDescription& scene, const RenderSettings& settings)>& measure);

/// Bit for bit. Invalid contributions count as pixels.
[[nodiscard]] int pixels_that_differ(const Picture& a, const Picture& b);

/// The largest relative deviation of any channel from `expected`. Infinite when a contribution was invalid.
[[nodiscard]] double deviation(const Picture& a, double expected);

/// Root of the mean squared difference over the mean of a, without the worst 3 % of channel values: those whose
/// paths met an edge that roundings put on their other side. Infinite when a
/// contribution was invalid.
[[nodiscard]] double relative_difference(const Picture& a, const Picture& b);

}  // namespace etendue::test
