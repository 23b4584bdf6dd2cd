#pragma once

#include <algorithm>
#include <initializer_list>

#include <etendue/render_settings.h>

namespace etendue {

/// Whether any of the AOVs is wanted: what nobody asks for is neither computed nor stored.
inline bool asks_for(const RenderSettings& settings, std::initializer_list<Aov> aovs) {
    return std::any_of(aovs.begin(), aovs.end(), [&](Aov aov) {
        return std::find(settings.aovs.begin(), settings.aovs.end(), aov) != settings.aovs.end();
    });
}

/// Whether camera samples go where the noise is. Where none carry light there is nothing to place.
inline bool places_samples(const RenderSettings& settings) {
    return settings.adaptive && settings.integrator != IntegratorKind::Light;
}

/// Whether the film has to know how far its replicates are apart.
inline bool keeps_replicates(const RenderSettings& settings) {
    return settings.error_target > 0 || asks_for(settings, {Aov::Variance}) || places_samples(settings);
}

}  // namespace etendue
