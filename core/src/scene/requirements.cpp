#include <etendue/requirements.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "bsdf/interior.h"
#include "bsdf/lobes.h"
#include "bsdf/material_fields.h"
#include "camera/camera.h"
#include "light/usd_lux.h"
#include "math/rgb.h"
#include "scene/requirements.h"
#include "util/asks_for.h"

namespace etendue {
namespace {

template <typename Item>
bool exists(int index, const std::vector<Item>& items) {
    return index >= 0 && static_cast<std::size_t>(index) < items.size();
}

/// Mesh lights whose material has no say: their surface absorbs whatever meets it.
bool hides_material(const SceneDescription& scene, std::size_t shape) {
    return std::any_of(scene.lights.begin(), scene.lights.end(), [shape](const LightDesc& light) {
        return light.kind == LightKind::Mesh && light.shape == static_cast<int>(shape) && !light.tinted_by_material;
    });
}

/// Notes what the placed shapes need, shape by shape.
class ShapeNeeds {
public:
    ShapeNeeds(const SceneDescription& scene, Requirements& needs) : scene_(scene), needs_(needs) {
        needs_.materials.resize(scene.materials.size());
        needs_.textures.resize(scene.textures.size());
        needs_.texture_coordinates.resize(scene.geometries.size());
    }

    void add(const ShapeDesc& shape, bool hidden_material) {
        add_normals(shape);
        if (hidden_material) return;
        for (int index : shape.materials) {
            if (!exists(index, scene_.materials)) continue;
            const MaterialDesc& material = scene_.materials[static_cast<std::size_t>(index)];
            needs_.materials[static_cast<std::size_t>(index)] = true;
            needs_.lights.emitting_surfaces |= is_emissive(material);
            add_coordinates(shape, material);
        }
    }

private:
    void add_normals(const ShapeDesc& shape) {
        if (!exists(shape.geometry, scene_.geometries)) return;
        const auto* mesh = std::get_if<MeshDesc>(&*scene_.geometries[static_cast<std::size_t>(shape.geometry)]);
        needs_.normals |= mesh != nullptr && !mesh->normals.empty();
    }

    void add_coordinates(const ShapeDesc& shape, const MaterialDesc& material) {
        if (!exists(shape.geometry, scene_.geometries)) return;
        CoordinateUse& use = needs_.texture_coordinates[static_cast<std::size_t>(shape.geometry)];
        use = std::max(use, coordinate_use(material));
    }

    static CoordinateUse coordinate_use(const MaterialDesc& material) {
        if (material.normal_texture >= 0) return CoordinateUse::Tangents;
        CoordinateUse use = CoordinateUse::Unused;
        for_each_input(material, [&use](const auto& input) {
            if (input.texture >= 0) use = CoordinateUse::Lookup;
        });
        return use;
    }

    const SceneDescription& scene_;
    Requirements& needs_;
};

void add_shapes(const SceneDescription& scene, Requirements& needs) {
    ShapeNeeds shapes(scene, needs);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) shapes.add(scene.shapes[i], hides_material(scene, i));
    const std::vector<bool> placed = placed_groups(scene);
    for (std::size_t group = 0; group < placed.size(); ++group) {
        if (!placed[group]) continue;
        for (const ShapeDesc& shape : scene.groups[group].shapes) shapes.add(shape, false);
    }
}

/// Marks the channels that the material reads.
void add_textures(const MaterialDesc& material, Requirements& needs) {
    const auto read = [&needs](int texture, int first, int last) {
        if (!exists(texture, needs.textures)) return;
        for (int channel = first; channel <= last; ++channel) {
            needs.textures[static_cast<std::size_t>(texture)].at(static_cast<std::size_t>(channel)) = true;
        }
    };
    for_each_input(material, [&read](const auto& input) {
        if constexpr (std::is_same_v<std::decay_t<decltype(input)>, ColorInput>) {
            read(input.texture, 0, 2);
        } else {
            // check_material complains of channels that do not exist.
            const int channel = std::clamp(input.channel, 0, 3);
            read(input.texture, channel, channel);
        }
    });
    read(material.normal_texture, 0, 2);
}

LobeSet operator|(const LobeSet& a, const LobeSet& b) {
    return {a.diffuse || b.diffuse,
            a.smooth_reflection || b.smooth_reflection,
            a.rough_reflection || b.rough_reflection,
            a.smooth_transmission || b.smooth_transmission,
            a.rough_transmission || b.rough_transmission,
            a.cutout || b.cutout};
}

void add_materials(const SceneDescription& scene, Requirements& needs) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (!needs.materials[i]) continue;
        const MaterialDesc& material = scene.materials[i];
        needs.lobes = needs.lobes | possible_lobes(material);
        needs.normal_maps |= material.normal_texture >= 0;
        const std::optional<Rgb> inside = interior_absorption(material);
        needs.absorption |= inside && !is_black(*inside);
        add_textures(material, needs);
    }
}

void add_light(const LightDesc& light, LightSet& lights) {
    if (!lux_emits(light)) return;
    switch (light.kind) {
        case LightKind::Rect:
        case LightKind::Disk:
        case LightKind::Mesh:
        case LightKind::Sphere:
        case LightKind::Cylinder:
            (lux_is_thin(light) ? lights.points : lights.areas) = true;
            break;
        case LightKind::Distant:
            lights.suns = true;
            break;
        case LightKind::Dome:
            lights.domes = true;
            break;
    }
}

/// Whether a ray can find light by chance.
bool light_is_seen(const SceneDescription& scene, const LightSet& lights) {
    const bool wide_sun = std::any_of(scene.lights.begin(), scene.lights.end(), [](const LightDesc& light) {
        return light.kind == LightKind::Distant && lux_distant_half_angle(light) > 0;
    });
    return lights.areas || lights.emitting_surfaces || lights.domes || wide_sun;
}

StrategySet asked_strategies(const RenderSettings& settings) {
    StrategySet asked = settings.strategies;
    switch (settings.integrator) {
        case IntegratorKind::Path:
            asked.connection = asked.light_image = asked.lens_hit = false;
            break;
        case IntegratorKind::Light:
            // Particle tracing alone: every light vertex is joined to the lens.
            asked = {false, false, false, true, false};
            break;
        case IntegratorKind::Bdpt:
        case IntegratorKind::Auto:  // may choose it
            break;
    }
    return asked;
}

/// theory.md §3: connections need a vertex that is no delta, at either end.
StrategySet carrying_strategies(const SceneDescription& scene, const RenderSettings& settings,
                                const Requirements& needs) {
    StrategySet set = asked_strategies(settings);
    const LobeSet& lobes = needs.lobes;
    const bool joins = lobes.diffuse || lobes.rough_reflection || lobes.rough_transmission;
    const bool traced = needs.lights.any() && settings.light_paths_per_pixel != 0.0;
    const bool seen = light_is_seen(scene, needs.lights);
    set.emission_hit &= seen;
    set.direct_light &= needs.lights.any() && joins && settings.max_depth >= 1;
    set.connection &= traced && joins && settings.max_depth >= 2;
    set.light_image &= traced && (joins || seen);
    set.lens_hit &= traced && needs.thin_lens;
    return set;
}

}  // namespace

bool is_emissive(const MaterialDesc& material) {
    return material.emission.texture >= 0 || max_component(Rgb(material.emission.value)) > 0;
}

std::vector<bool> placed_groups(const SceneDescription& scene) {
    std::vector<bool> placed(scene.groups.size());
    for (const InstanceDesc& instance : scene.instances) {
        if (exists(instance.group, scene.groups)) placed[static_cast<std::size_t>(instance.group)] = true;
    }
    return placed;
}

Requirements find_requirements(const SceneDescription& scene, const RenderSettings& settings) {
    Requirements needs;
    add_shapes(scene, needs);
    add_materials(scene, needs);
    for (const LightDesc& light : scene.lights) add_light(light, needs.lights);
    needs.thin_lens =
        exists(settings.camera, scene.cameras) && has_lens(scene.cameras[static_cast<std::size_t>(settings.camera)]);
    needs.strategies = carrying_strategies(scene, settings, needs);
    needs.light_paths = needs.strategies.connection || needs.strategies.light_image || needs.strategies.lens_hit;
    needs.instances = !scene.instances.empty();
    needs.first_surface = asks_for(settings, {Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo});
    needs.replicates = keeps_replicates(settings);
    needs.aovs = settings.aovs;
    return needs;
}

}  // namespace etendue
