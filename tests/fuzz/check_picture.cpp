#include "fuzz/check_picture.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "fuzz/outcome.h"

namespace etendue::test {
namespace {

constexpr const char* kInvalidNames[kInvalidKinds]{"not numbers", "infinite", "negative"};

[[noreturn]] void fail(const std::string& what, std::size_t index, float value) {
    std::ostringstream text;
    text << what << '[' << index << "] = " << value;
    throw Finding(text.str());
}

/// What an AOV promises of each value (film_view.h).
bool holds(Aov aov, float value, bool any_hit, bool may_overflow) {
    switch (aov) {
        case Aov::Alpha:
            return value >= 0 && value <= 1 + 1e-6F;
        case Aov::Depth:
            return !std::isnan(value) && (any_hit ? std::isfinite(value) && value >= 0 : value >= 0);
        case Aov::Normal:
            return std::abs(value) <= 1 + 1e-6F;
        case Aov::Variance:
            return value >= 0;  // infinite while it is unknown
        case Aov::Color:
            return value >= 0 && (std::isfinite(value) || may_overflow);
        default:
            return std::isfinite(value) && value >= 0;
    }
}

/// Of the finite values of colours.
float brightest(const RenderedImage& image) {
    float most = 0;
    const auto look_at = [&](const std::vector<float>& data) {
        for (const float value : data) most = std::isfinite(value) ? std::max(most, value) : most;
    };
    if (const AovImage* color = image.find(Aov::Color)) look_at(color->data);
    for (const StrategyImage& strategy : image.strategy_images) look_at(strategy.data);
    return most;
}

/// `may_overflow`: lamps may be brighter than a float can say.
void check_values(const RenderedImage& image, bool may_overflow) {
    const AovImage* alpha = image.find(Aov::Alpha);
    for (const AovImage& aov : image.aovs) {
        const auto channels = static_cast<std::size_t>(aov.channels);
        for (std::size_t i = 0; i < aov.data.size(); ++i) {
            const bool any_hit = alpha != nullptr && alpha->data[i / channels] > 0;
            if (!holds(aov.aov, aov.data[i], any_hit, may_overflow))
                fail(std::string(aov_name(aov.aov)), i, aov.data[i]);
        }
    }
    for (const StrategyImage& strategy : image.strategy_images) {
        for (std::size_t i = 0; i < strategy.data.size(); ++i) {
            const float value = strategy.data[i];
            if (!(value >= 0 && (std::isfinite(value) || may_overflow))) fail(strategy_image_name(strategy), i, value);
        }
    }
}

void check_statistics(const RenderStatistics& statistics) {
    for (std::size_t kind = 0; kind < kInvalidKinds; ++kind) {
        if (statistics.invalid[kind] == 0) continue;
        throw Finding(std::to_string(statistics.invalid[kind]) + " contributions are " + kInvalidNames[kind]);
    }
    if (!(statistics.error >= 0)) throw Finding("the error is " + std::to_string(statistics.error));
}

void check_radiance(const RenderedImage& image, double radiance) {
    const AovImage* color = image.find(Aov::Color);
    for (std::size_t i = 0; color != nullptr && i < color->data.size(); ++i) {
        if (std::abs(color->data[i] / radiance - 1) > 1e-5) fail("not " + std::to_string(radiance), i, color->data[i]);
    }
}

}  // namespace

void check_picture(const RenderedImage& image, const Trial& trial) {
    check_statistics(image.statistics);
    // An infinity among tame values is a finding; among the largest, a float's end.
    constexpr float kNearlyTooBright = 1e34F;
    check_values(image, trial.hostile || brightest(image) > kNearlyTooBright);
    if (trial.radiance && image.statistics.passes == trial.settings.samples_per_pixel) {
        check_radiance(image, *trial.radiance);
    }
}

void check_same(const RenderedImage& a, const RenderedImage& b) {
    for (std::size_t k = 0; k < a.aovs.size(); ++k) {
        for (std::size_t i = 0; i < a.aovs[k].data.size(); ++i) {
            const float value = b.aovs[k].data[i];
            if (value != a.aovs[k].data[i])
                fail("another number of threads: " + std::string(aov_name(a.aovs[k].aov)), i, value);
        }
    }
}

}  // namespace etendue::test
