#pragma once

namespace etendue {

/// One light of several.
struct LightChoice {
    int light = -1;  ///< index
    double pmf = 0;
};

}  // namespace etendue
