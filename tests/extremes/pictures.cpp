#include "extremes/pictures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "extremes/extreme.h"
#include "math/constants.h"
#include "support/replicas.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

SceneDescription tinted_pool() {
    SceneDescription scene = pool();
    auto& water = std::get<DielectricMaterial>(scene.materials.back().model);
    water.transmission_tint.value = {0.3, 0.6, 0.9};
    water.transmission_depth = 0.5;
    return scene;
}

}  // namespace

const std::vector<NamedScene>& all_kinds_of_scenes() {
    static const std::vector<NamedScene> scenes{
        {"diffuse box", diffuse_box()},
        {"smooth glass", glass_box()},
        {"rough glass", rough_glass_box()},
        {"coats and panes", layered_box()},
        {"sky and sun", sky()},
        {"beams", shaped_lights()},
        {"lights of all kinds", many_lights()},
        {"point light and sun", delta_lights()},
        {"thin lens", lens_box()},
        {"orthographic", orthographic_box()},
        {"instances", instanced_box()},
        {"absorbing water", tinted_pool()},
    };
    return scenes;
}

RenderSettings quick_settings(IntegratorKind integrator) {
    RenderSettings settings = small_settings(integrator, 12, 4);
    settings.seed = 1;
    return settings;
}

Worst worst_of_all(const std::function<double(const SceneDescription&, const RenderSettings&)>& measure) {
    Worst worst;
    for (const NamedScene& named : all_kinds_of_scenes()) {
        for (const IntegratorKind integrator : kIntegrators) {
            const double figure = measure(named.scene, quick_settings(integrator));
            if (figure > worst.figure) worst = {figure, named.name};
        }
    }
    return worst;
}

double Picture::mean() const { return std::accumulate(rgb.begin(), rgb.end(), 0.0) / static_cast<double>(rgb.size()); }

Picture picture(const SceneDescription& scene, const RenderSettings& settings) {
    const RenderedImage image = render(scene, settings);
    return {image.find(Aov::Color)->data, invalid(image.statistics)};
}

int pixels_that_differ(const Picture& a, const Picture& b) {
    int different = static_cast<int>(a.invalid + b.invalid);
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        different += std::equal(a.rgb.begin() + static_cast<std::ptrdiff_t>(i),
                                a.rgb.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                                b.rgb.begin() + static_cast<std::ptrdiff_t>(i))
                         ? 0
                         : 1;
    }
    return different;
}

double deviation(const Picture& a, double expected) {
    if (a.invalid > 0) return kInfinity;
    double worst = 0;
    for (const float x : a.rgb) worst = std::max(worst, std::abs(static_cast<double>(x) / expected - 1));
    return worst;
}

double relative_difference(const Picture& a, const Picture& b) {
    std::vector<double> squares;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        const double difference = static_cast<double>(a.rgb[i]) - static_cast<double>(b.rgb[i]);
        squares.push_back(difference * difference);
    }
    if (a.invalid + b.invalid > 0) return kInfinity;
    std::sort(squares.begin(), squares.end());
    squares.resize(squares.size() - squares.size() * 3 / 100);
    return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0) / static_cast<double>(squares.size())) /
           a.mean();
}

}  // namespace etendue::test
