#include "fuzz/settings.h"

namespace etendue::test {
namespace {

void choose_size(Dice& dice, RenderSettings& settings) {
    if (dice.chance(0.1)) {
        settings.width = dice.one_of({1, 1, 64});
        settings.height = settings.width == 64 ? 1 : dice.one_of({1, 64});
    } else {
        settings.width = dice.whole(1, dice.chance(0.1) ? 16 : 7);
        settings.height = dice.whole(1, dice.chance(0.1) ? 16 : 7);
    }
    if (dice.chance(0.15)) {
        const int x0 = dice.below(settings.width);
        const int y0 = dice.below(settings.height);
        settings.crop = PixelWindow{x0, y0, dice.whole(x0 + 1, settings.width), dice.whole(y0 + 1, settings.height)};
    }
    settings.conform = dice.one_of({ApertureConform::ExpandAperture, ApertureConform::CropAperture,
                                    ApertureConform::AdjustApertureWidth, ApertureConform::AdjustApertureHeight,
                                    ApertureConform::AdjustPixelAspect});
}

void choose_strategies(Dice& dice, RenderSettings& settings) {
    if (dice.chance(0.2)) {
        const auto on = [&] { return dice.chance(0.6); };
        settings.strategies = {on(), on(), on(), on(), on()};
    }
    const bool bdpt = settings.integrator == IntegratorKind::Bdpt;
    if (bdpt && dice.chance(0.15)) {
        const int s = dice.below(5);
        settings.single_strategy = Strategy{s, dice.whole(s < 2 ? 2 - s : 0, 5)};
    } else if (settings.integrator != IntegratorKind::Path && dice.chance(0.15)) {
        settings.strategy_images = dice.whole(1, 6);
    }
    if (dice.chance(0.4)) settings.light_paths_per_pixel = dice.one_of({0.01, 0.3, 1.0, 3.0});
    if (bdpt && dice.chance(0.05)) settings.light_paths_per_pixel = 0;
}

void choose_aovs(Dice& dice, RenderSettings& settings) {
    if (dice.chance(0.3)) return;
    settings.aovs.clear();
    for (const Aov aov :
         {Aov::Color, Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo, Aov::SampleCount, Aov::Variance}) {
        if (dice.chance(0.7)) settings.aovs.push_back(aov);
    }
}

}  // namespace

RenderSettings random_settings(Dice& dice) {
    RenderSettings settings;
    settings.integrator =
        dice.one_of({IntegratorKind::Path, IntegratorKind::Light, IntegratorKind::Bdpt, IntegratorKind::Bdpt});
    choose_size(dice, settings);
    settings.samples_per_pixel = dice.whole(1, 4);
    settings.max_depth = dice.chance(0.05) ? 50 : dice.below(9);
    settings.seed = static_cast<std::uint64_t>(dice.below(1000));
    settings.threads = dice.whole(1, 2);
    if (dice.chance(0.3)) {
        settings.filter.kind = dice.one_of({FilterKind::Box, FilterKind::Triangle, FilterKind::Gaussian});
        settings.filter.radius = dice.one_of({0.5, 1.0, 1.5, 3.0, 1e-6, 1e-20, 20.0});
    }
    settings.filter.radius = dice.number(settings.filter.radius);
    if (dice.chance(0.3)) settings.heuristic = MisHeuristic::Balance;
    choose_strategies(dice, settings);
    settings.roulette_depth = dice.one_of({4, 4, 0, 1, -1});
    if (dice.chance(0.15)) settings.adjoint = {dice.chance(0.5), dice.chance(0.5), dice.chance(0.5)};
    if (dice.chance(0.05)) {
        settings.error_target = dice.one_of({1e-3, 0.1, 10.0, 1e-20, 1e20});
        settings.samples_per_pixel = 40;
    }
    choose_aovs(dice, settings);
    return settings;
}

}  // namespace etendue::test
