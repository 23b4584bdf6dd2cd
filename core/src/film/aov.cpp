#include <etendue/film_view.h>

namespace etendue {

std::string_view aov_name(Aov aov) {
    switch (aov) {
        case Aov::Color:
            return "color";
        case Aov::Alpha:
            return "alpha";
        case Aov::Depth:
            return "depth";
        case Aov::Normal:
            return "normal";
        case Aov::Albedo:
            return "albedo";
        case Aov::SampleCount:
            return "sample_count";
        case Aov::Variance:
            return "variance";
    }
    return "";
}

int aov_channels(Aov aov) {
    switch (aov) {
        case Aov::Color:
        case Aov::Normal:
        case Aov::Albedo:
        case Aov::Variance:
            return 3;
        case Aov::Alpha:
        case Aov::Depth:
        case Aov::SampleCount:
            break;
    }
    return 1;
}

std::string strategy_image_name(const StrategyImage& image) {
    return std::string(image.weighted ? "st.weighted.s" : "st.unweighted.s") + std::to_string(image.strategy.s) + "t" +
           std::to_string(image.strategy.t);
}

}  // namespace etendue
