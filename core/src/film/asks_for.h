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

}  // namespace etendue
