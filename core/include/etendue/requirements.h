#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <etendue/export.h>
#include <etendue/render_settings.h>
#include <etendue/scene_description.h>

namespace etendue {

/// Kinds of scattering that points of a surface may show. A textured input counts as all the values it may have.
struct LobeSet {
    bool diffuse = false;
    bool smooth_reflection = false;
    bool rough_reflection = false;
    bool smooth_transmission = false;
    bool rough_transmission = false;
    bool cutout = false;  ///< the surface is not there, or only partly
};

struct LightSet {
    bool areas = false;              ///< of UsdLux, mesh lights too
    bool emitting_surfaces = false;  ///< shapes whose material glows
    bool points = false;             ///< and lines: no path finds them by chance
    bool suns = false;               ///< distant lights
    bool domes = false;

    [[nodiscard]] bool any() const { return areas || emitting_surfaces || points || suns || domes; }
};

/// What hits on a geometry have to know of their texture coordinates. Each includes the ones before.
enum class CoordinateUse { Unused, Lookup, Tangents };

/// What a render has to have. Only what is placed counts, and only what emits: nothing else is converted, opened,
/// sampled or stored. Derived from descriptions; no file is looked at.
struct Requirements {
    std::vector<bool> materials;                     ///< by material: whether a placed shape is made of it
    std::vector<std::array<bool, 4>> textures;       ///< by texture: which of r, g, b, a are read; none: never opened
    std::vector<CoordinateUse> texture_coordinates;  ///< by geometry
    LobeSet lobes;
    LightSet lights;
    StrategySet strategies;  ///< those that are asked for and can carry light here
    bool light_paths = false;
    bool thin_lens = false;
    bool absorption = false;  ///< paths keep account of the bodies that they are in
    bool instances = false;
    bool normals = false;  ///< some mesh shades with normals of its own
    bool normal_maps = false;
    bool first_surface = false;  ///< an AOV describes what camera rays meet first
    bool replicates = false;     ///< variance or error is asked for
    std::vector<Aov> aovs;
};

/// Needs nothing of the description to be right: what refers to things that do not exist requires none of them.
[[nodiscard]] ETENDUE_EXPORT Requirements find_requirements(const SceneDescription& scene,
                                                            const RenderSettings& settings);

/// Bytes that the parts of a render hold; what building them takes for a while is not in it.
struct MemoryUse {
    std::size_t vertices = 0;        ///< what is traced: positions, triangles, normals, texture coordinates
    std::size_t acceleration = 0;    ///< Embree's own count
    std::size_t lights = 0;          ///< their triangles and tables
    std::size_t textures = 0;        ///< texels in the cache now
    std::size_t textures_limit = 0;  ///< how many there may be; 0 without textures
    std::size_t film = 0;            ///< once all of its planes are in use
};

}  // namespace etendue
