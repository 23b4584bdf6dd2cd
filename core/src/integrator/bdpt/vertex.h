#pragma once

#include <optional>
#include <vector>

#include "bsdf/bsdf.h"
#include "camera/camera.h"
#include "geometry/surface_interaction.h"
#include "integrator/bdpt/mis.h"
#include "light/light.h"
#include "math/rgb.h"
#include "scene/media.h"

namespace etendue {

/// A surface vertex of a subpath.
struct Vertex {
    SurfaceInteraction si;
    std::optional<Bsdf> bsdf;  ///< empty where everything is absorbed
    Vec3 wo;                   ///< towards the previous vertex
    Rgb beta;                  ///< alpha of theory.md §2 without the BSDF at this vertex
    MisState mis;
    Media media;  ///< on wo's side; only where there is absorption

    [[nodiscard]] bool connectible() const { return bsdf && bsdf->connectible(); }
};

/// y0 of a light subpath.
struct LightStart {
    int light = -1;
    LightPoint y;
    double pdf_point = 0;  ///< of y, native measure, light's choice included
};

/// A light path's ray that crosses the lens (t = 0).
struct LensCrossing {
    LensHit hit;
    Rgb beta;
    MisState mis;  ///< as of a vertex on the lens
    int s = 0;     ///< light vertices, the one on the lens included
};

/// A camera path's ray that meets nothing.
struct Escape {
    Vec3 direction;
    Rgb beta;
    MisState mis;  ///< as of a vertex at infinity, densities per solid angle
    Vec3 from;
    int t = 0;  ///< camera vertices, the one at infinity included
};

struct LightSubpath {
    std::optional<LightStart> start;
    std::vector<Vertex> vertices;  ///< y1, y2, ...
    std::vector<LensCrossing> crossings;

    void clear() {
        start.reset();
        vertices.clear();
        crossings.clear();
    }
};

struct CameraSubpath {
    Vec3 origin;                   ///< z0
    std::vector<Vertex> vertices;  ///< z1, z2, ...
    std::optional<Escape> escape;

    void clear() {
        vertices.clear();
        escape.reset();
    }
};

}  // namespace etendue
