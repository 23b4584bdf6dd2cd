#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <etendue/render_session.h>
#include <etendue/render_settings.h>

#include "geometry.h"

namespace etendue::hydra {

/// What the indices of an assembled SceneDescription stand for in Hydra.
struct PrimTable {
    struct Shape {
        int prim_id = -1;
        std::shared_ptr<const Geometry> geometry;
    };
    struct Instance {
        std::size_t group = 0;
        int number = 0;  ///< among those of the same prim
    };
    std::vector<Shape> shapes;
    std::vector<Shape> groups;  ///< each has one shape
    std::vector<Instance> instances;
};

/// What each pixel shows, row 0 on top; -1: nothing. Elements are faces as authored.
struct Identifiers {
    std::vector<std::int32_t> prims;
    std::vector<std::int32_t> instances;
    std::vector<std::int32_t> elements;
};

/// By what lies behind the centres of the window's pixels. Ends early, with nothing, once `is_stale`.
/// On one thread: renders need the others.
[[nodiscard]] Identifiers identify(const RenderSession& session, const PixelWindow& window, const PrimTable& table,
                                   const std::function<bool()>& is_stale);

}  // namespace etendue::hydra
