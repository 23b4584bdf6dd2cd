#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <etendue/picked_surface.h>
#include <etendue/requirements.h>
#include <etendue/scene_description.h>

#include "accel/embree_accel.h"
#include "bsdf/material.h"
#include "geometry/ray.h"
#include "geometry/surface_interaction.h"
#include "light/emission_aim.h"
#include "light/light.h"
#include "light/light_sampler.h"
#include "scene/absorption.h"
#include "scene/placed_shape.h"
#include "scene/world_origin.h"
#include "texture/texture_set.h"

namespace etendue {

/// One end of a visibility ray. Points that lie on no surface (a lens, a point light) have zero error.
struct RayEnd {
    Vec3 p;
    Vec3 p_error;
    Vec3 n_g;

    static RayEnd on(const SurfaceInteraction& si) { return {si.p, si.p_error, si.n_g}; }
    static RayEnd on(const LightPoint& y) { return {y.p, y.p_error, y.n}; }
    static RayEnd free(const Vec3& p) { return {p, {}, {}}; }
};

class Scene;

struct SceneOptions {
    /// What there has to be; of anything else nothing is built, opened or checked. Without light paths nobody will ask
    /// where these had best go, and Scene::emission() is each light's own.
    const Requirements& needs;
    Origins origins{};  ///< from which positions are measured
    double texture_memory = kDefaultTextureMemory;
    /// An earlier scene: what it has built alike is taken over.
    const Scene* before = nullptr;
    /// The description itself, if nobody has a use for it any more: its geometries go once all shapes are placed.
    SceneDescription* spent = nullptr;
};

/// Everything that paths meet, ready to be traced. Immutable; safe to use from any number of threads.
class Scene {
public:
    /// `lens_points` are positions that light must be able to reach besides the geometry (cameras with a lens). All
    /// positions, those of `lens_points` too, are relative to `options.origins.world`. Throws SceneError or FileError
    /// naming the prim or file.
    Scene(const SceneDescription& description, const std::vector<Vec3>& lens_points, const SceneOptions& options);
    /// For a render with the default settings.
    Scene(const SceneDescription& description, const std::vector<Vec3>& lens_points);
    // Lights refer to the textures and materials in here.
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    [[nodiscard]] std::optional<SurfaceInteraction> intersect(const Ray& ray) const;
    /// Which surface that is.
    [[nodiscard]] std::optional<PickedSurface> pick(const Ray& ray) const;
    [[nodiscard]] bool visible(const RayEnd& a, const RayEnd& b) const;
    /// Whether nothing lies from `a` along the unit `direction`.
    [[nodiscard]] bool sees_infinity(const RayEnd& a, const Vec3& direction) const;

    /// All but the film's.
    [[nodiscard]] MemoryUse memory_use() const;
    [[nodiscard]] const SceneBounds& bounds() const { return bounds_; }

    /// Surfaces without a material (lights' own shapes) absorb everything.
    [[nodiscard]] static bool scatters(const SurfaceInteraction& si) { return si.material >= 0; }
    /// Needs scatters(si).
    [[nodiscard]] Bsdf bsdf(const SurfaceInteraction& si) const {
        return make_bsdf(materials_[static_cast<std::size_t>(si.material)], *textures_, si);
    }
    [[nodiscard]] Rgb albedo(const SurfaceInteraction& si) const;
    /// What the surface shades with: n_s, with the material's normal map if it has one.
    [[nodiscard]] Vec3 shading_normal(const SurfaceInteraction& si) const;

    /// Whether any body absorbs light inside it. If none does, all media are those of nowhere.
    [[nodiscard]] bool absorbs() const { return absorption_.any(); }
    [[nodiscard]] const Absorption& absorption() const { return absorption_; }
    /// The media into which a light emits. A light has one: one that lies partly in a body is taken to lie where most
    /// of what it emits goes. Infinite lights lie outside.
    [[nodiscard]] Media light_media(int light) const {
        return absorbs() ? light_media_[static_cast<std::size_t>(light)] : Media{};
    }

    [[nodiscard]] const Light& light(int index) const { return *lights_[static_cast<std::size_t>(index)]; }
    [[nodiscard]] const std::vector<int>& infinite_lights() const { return infinite_lights_; }
    [[nodiscard]] const LightSampler& light_sampler() const { return *light_sampler_; }
    /// How light subpaths start.
    [[nodiscard]] const EmissionAim& emission() const { return emission_; }
    [[nodiscard]] std::size_t light_count() const { return lights_.size(); }
    /// Whether some light may reach the camera that no path from there can find: a delta light behind a delta lobe.
    [[nodiscard]] bool needs_light_paths() const;

private:
    /// All that the textures depend on.
    struct TextureFiles {
        std::vector<TextureDesc> descs;  ///< the scene's, then the lights'
        std::vector<bool> unused;
        double megabytes = 0;

        [[nodiscard]] bool operator==(const TextureFiles&) const = default;
    };
    struct Instance {
        std::size_t group;
        Transform world_from_group;
        std::vector<std::vector<int>> lights;  ///< [shape][slot]; empty: none
    };

    void make_textures(const SceneDescription& description, const SceneOptions& options);
    void place_shapes(const SceneDescription& description, const SceneOptions& options, const KnownGeometry& known);
    void place_instances(const SceneDescription& description, const Origins& origins);
    void place_light_shapes(const std::vector<LightDesc>& lights, const KnownGeometry& known);
    [[nodiscard]] KnownGeometry known_geometry() const;
    [[nodiscard]] AccelInput accel_input() const;
    void build_accel(const Scene* before);
    void check_instances(const SceneDescription& description) const;
    [[nodiscard]] SceneBounds find_bounds(const std::vector<Vec3>& lens_points) const;
    void make_lights(const std::vector<LightDesc>& lights, std::size_t material_textures);
    /// A mesh light's part in one material slot, tinted by that slot's material.
    [[nodiscard]] std::unique_ptr<Light> make_tinted_light(const LightDesc& desc, const PlacedShape& shape,
                                                           std::size_t slot) const;
    void make_emissive_lights();
    std::vector<int> make_slot_lights(const PlacedShape& shape, const Transform& world_from_parent);
    int add_light(std::unique_ptr<Light> light);
    [[nodiscard]] std::vector<Sphere> find_casters() const;

    TextureFiles texture_files_;
    std::shared_ptr<const TextureSet> textures_;
    std::vector<MaterialDesc> materials_;
    Absorption absorption_;
    std::vector<Media> light_media_;   ///< empty when nothing absorbs
    std::vector<PlacedShape> shapes_;  ///< top level; the lights' own shapes come last
    std::vector<std::vector<PlacedShape>> groups_;
    std::vector<Instance> instances_;
    std::vector<std::unique_ptr<Light>> lights_;
    std::vector<int> infinite_lights_;
    SceneBounds bounds_;  ///< of all that is finite, lenses included
    std::unique_ptr<LightSampler> light_sampler_;
    EmissionAim emission_;
    std::shared_ptr<const EmbreeAccel> accel_;
};

}  // namespace etendue
