#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include <etendue/error.h>

#include "light/make_light.h"
#include "light/texture_image.h"
#include "light/usd_lux.h"
#include "scene/casters.h"
#include "scene/check_material.h"
#include "scene/instance_reach.h"
#include "scene/interaction.h"
#include "scene/known_geometry.h"
#include "scene/light_triangles.h"
#include "scene/material_glow.h"
#include "scene/media_probe.h"
#include "scene/requirements.h"
#include "texture/udim.h"

namespace etendue {
namespace {

Transform instance_transform(const InstanceDesc& instance, const Origins& origins) {
    const Vec3 group_origin = origins.of_group(static_cast<std::size_t>(instance.group));
    try {
        return Transform(measured_from(group_origin, relative_to(origins.world, instance.world_from_group)));
    } catch (const SceneError& error) {
        throw SceneError(instance.name + ": " + error.what());
    }
}

std::vector<const PlacedGeometry*> geometries(const std::vector<PlacedShape>& shapes) {
    std::vector<const PlacedGeometry*> out;
    for (const PlacedShape& shape : shapes) out.push_back(shape.geometry.get());
    return out;
}

/// Shapes that serve as mesh lights, by the light that does.
std::vector<int> mesh_light_shapes(const SceneDescription& description) {
    std::vector<int> light_of_shape(description.shapes.size(), -1);
    for (std::size_t i = 0; i < description.lights.size(); ++i) {
        const LightDesc& light = description.lights[i];
        if (light.kind != LightKind::Mesh) continue;
        if (light.shape < 0 || light.shape >= static_cast<int>(light_of_shape.size())) {
            throw SceneError(light.name + ": mesh light has no shape");
        }
        int& taken = light_of_shape[static_cast<std::size_t>(light.shape)];
        if (taken >= 0) throw SceneError(light.name + ": another mesh light has the same shape");
        taken = static_cast<int>(i);
    }
    return light_of_shape;
}

/// The scene's textures, then those of its lights in the order of the lights that have one.
std::vector<TextureDesc> all_textures(const SceneDescription& description) {
    std::vector<TextureDesc> textures = description.textures;
    for (const LightDesc& light : description.lights) {
        std::optional<TextureDesc> texture = lux_texture(light);
        if (!texture) continue;
        if (is_udim(texture->file)) throw SceneError(light.name + ": a light's texture cannot be a UDIM set");
        textures.push_back(std::move(*texture));
    }
    return textures;
}

/// The materials by their index; in place of one that nothing is made of, one that needs nothing.
std::vector<MaterialDesc> needed_materials(const SceneDescription& description, const Requirements& needs) {
    std::vector<MaterialDesc> materials(description.materials.size());
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (needs.materials[i]) materials[i] = description.materials[i];
    }
    return materials;
}

std::vector<LightDesc> relative_lights(const SceneDescription& description, const Vec3& origin) {
    std::vector<LightDesc> lights = description.lights;
    for (LightDesc& light : lights) light.world_from_light = relative_to(origin, light.world_from_light);
    return lights;
}

}  // namespace

Scene::Scene(const SceneDescription& description, const std::vector<Vec3>& lens_points)
    : Scene(description, lens_points, {find_requirements(description, {})}) {}

Scene::Scene(const SceneDescription& description, const std::vector<Vec3>& lens_points, const SceneOptions& options)
    : materials_(needed_materials(description, options.needs)), absorption_(materials_) {
    make_textures(description, options);
    for (const MaterialDesc& material : materials_) check_material(material, description.textures.size());
    const std::vector<LightDesc> lights = relative_lights(description, options.origins.world);
    const KnownGeometry known = options.before != nullptr ? options.before->known_geometry() : KnownGeometry{};
    place_shapes(description, options, known);
    place_instances(description, options.origins);
    place_light_shapes(lights, known);
    if (options.spent != nullptr) options.spent->geometries.clear();
    build_accel(options.before);
    bounds_ = find_bounds(lens_points);
    check_instances(description);
    make_lights(lights, description.textures.size());
    make_emissive_lights();
    light_sampler_ = std::make_unique<LightSampler>(lights_, bounds_);
    if (absorbs()) {
        for (const auto& light : lights_) light_media_.push_back(media_before(*this, *light));
    }
    if (options.needs.light_paths) emission_ = EmissionAim(cluster(find_casters(), EmissionAim::kMostTargets));
}

void Scene::make_textures(const SceneDescription& description, const SceneOptions& options) {
    texture_files_ = {all_textures(description), {}, options.texture_memory};
    texture_files_.unused.resize(texture_files_.descs.size());
    std::transform(options.needs.textures.begin(), options.needs.textures.end(), texture_files_.unused.begin(),
                   [](const std::array<bool, 4>& channels) { return channels == std::array<bool, 4>{}; });
    const bool same = options.before != nullptr && options.before->texture_files_ == texture_files_;
    textures_ = same ? options.before->textures_
                     : std::make_shared<const TextureSet>(texture_files_.descs, texture_files_.megabytes,
                                                          texture_files_.unused);
}

KnownGeometry Scene::known_geometry() const {
    KnownGeometry known;
    known.add(shapes_);
    for (const auto& group : groups_) known.add(group);
    known.sort();
    return known;
}

void Scene::place_shapes(const SceneDescription& description, const SceneOptions& options, const KnownGeometry& known) {
    const std::vector<CoordinateUse>& coordinates = options.needs.texture_coordinates;
    const std::vector<int> light_of_shape = mesh_light_shapes(description);
    for (std::size_t i = 0; i < description.shapes.size(); ++i) {
        shapes_.push_back(place_shape(description.shapes[i], description, light_of_shape[i] >= 0, coordinates, known,
                                      options.origins.world));
    }
    const std::vector<bool> placed = placed_groups(description);
    groups_.resize(placed.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (!placed[i]) continue;
        for (const ShapeDesc& shape : description.groups[i].shapes) {
            groups_[i].push_back(
                place_shape(shape, description, false, coordinates, known, options.origins.of_group(i)));
        }
    }
}

void Scene::place_instances(const SceneDescription& description, const Origins& origins) {
    for (const InstanceDesc& instance : description.instances) {
        if (instance.group < 0 || instance.group >= static_cast<int>(groups_.size())) {
            throw SceneError(instance.name + ": group index " + std::to_string(instance.group) + " is out of range");
        }
        instances_.push_back({static_cast<std::size_t>(instance.group), instance_transform(instance, origins), {}});
    }
}

void Scene::place_light_shapes(const std::vector<LightDesc>& lights, const KnownGeometry& known) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        std::optional<LightShape> shape = make_light_shape(lights[i]);
        if (!shape) continue;
        PlacedShape placed;
        placed.name = lights[i].name;
        placed.geometry = known.light_shape(number++, std::move(*shape));
        placed.materials = {-1};
        placed.lights = {static_cast<int>(i)};
        shapes_.push_back(std::move(placed));
    }
}

AccelInput Scene::accel_input() const {
    AccelInput input;
    input.top = geometries(shapes_);
    for (const auto& group : groups_) input.groups.push_back(geometries(group));
    for (const Instance& instance : instances_) input.instances.push_back({instance.group, instance.world_from_group});
    return input;
}

void Scene::build_accel(const Scene* before) {
    const AccelInput input = accel_input();
    const bool same = before != nullptr && before->accel_input() == input;
    accel_ = same ? before->accel_ : std::make_shared<const EmbreeAccel>(input);
}

SceneBounds Scene::find_bounds(const std::vector<Vec3>& lens_points) const {
    std::optional<AccelBounds> box = accel_->bounds();
    for (const Vec3& p : lens_points) {
        box = box ? AccelBounds{min(box->lower, p), max(box->upper, p)} : AccelBounds{p, p};
    }
    if (!box) return {};
    const Vec3 center = (box->lower + box->upper) * 0.5;
    const double radius = length(box->upper - center);
    return {center, radius > 0 ? radius : 1};
}

void Scene::check_instances(const SceneDescription& description) const {
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        if (takes_rays_from(bounds_, instances_[i].world_from_group)) continue;
        throw SceneError(description.instances[i].name + ": it is too small, too large or too far away");
    }
}

int Scene::add_light(std::unique_ptr<Light> light) {
    const int index = static_cast<int>(lights_.size());
    if (light->infinite()) infinite_lights_.push_back(index);
    lights_.push_back(std::move(light));
    return index;
}

void Scene::make_lights(const std::vector<LightDesc>& lights, std::size_t material_textures) {
    auto next_texture = static_cast<int>(material_textures);
    for (const LightDesc& desc : lights) {
        if (desc.kind != LightKind::Mesh) {
            const bool textured = lux_texture(desc).has_value();
            add_light(make_light(desc, bounds_,
                                 textured ? std::make_shared<TextureImage>(*textures_, next_texture++) : nullptr));
            continue;
        }
        PlacedShape& shape = shapes_[static_cast<std::size_t>(desc.shape)];
        const auto& mesh = std::get<TriangleMesh>(*shape.geometry);
        if (desc.tinted_by_material) {
            shape.lights = {add_light(make_tinted_light(desc, shape, 0))};
            continue;
        }
        shape.materials.assign(shape.materials.size(), -1);
        shape.lights.assign(shape.materials.size(),
                            add_light(make_mesh_light(desc, light_triangles(mesh, -1, {}), {})));
    }
    // The description's lights keep their indices: those of further slots follow.
    for (const LightDesc& desc : lights) {
        if (desc.kind != LightKind::Mesh || !desc.tinted_by_material) continue;
        PlacedShape& shape = shapes_[static_cast<std::size_t>(desc.shape)];
        for (std::size_t slot = 1; slot < shape.materials.size(); ++slot) {
            shape.lights.push_back(add_light(make_tinted_light(desc, shape, slot)));
        }
    }
}

std::unique_ptr<Light> Scene::make_tinted_light(const LightDesc& desc, const PlacedShape& shape,
                                                std::size_t slot) const {
    const auto& mesh = std::get<TriangleMesh>(*shape.geometry);
    auto glow = std::make_shared<MaterialGlow>(materials_[static_cast<std::size_t>(shape.materials[slot])], *textures_);
    return make_mesh_light(desc, light_triangles(mesh, static_cast<int>(slot), {}), std::move(glow),
                           MeshLight::world_area(light_triangles(mesh, -1, {})));
}

std::vector<int> Scene::make_slot_lights(const PlacedShape& shape, const Transform& world_from_parent) {
    std::vector<int> lights(shape.materials.size(), -1);
    const auto* mesh = std::get_if<TriangleMesh>(shape.geometry.get());
    if (mesh == nullptr) return lights;
    for (std::size_t slot = 0; slot < lights.size(); ++slot) {
        const int material_index = shape.materials[slot];
        if (material_index < 0) continue;
        const MaterialDesc& material = materials_[static_cast<std::size_t>(material_index)];
        if (!is_emissive(material)) continue;
        std::vector<LightTriangle> triangles = light_triangles(*mesh, static_cast<int>(slot), world_from_parent);
        if (!(MeshLight::world_area(triangles) > 0)) continue;
        const bool textured = material.emission.texture >= 0;
        lights[slot] = add_light(std::make_unique<MeshLight>(
            std::move(triangles), textured ? Rgb(1) : material_emission(material, *textures_, {}),
            textured ? std::make_shared<MaterialGlow>(material, *textures_) : nullptr));
    }
    return lights;
}

void Scene::make_emissive_lights() {
    const auto emits = [this](const PlacedShape& shape) {
        for (int material : shape.materials) {
            if (material >= 0 && is_emissive(materials_[static_cast<std::size_t>(material)])) return true;
        }
        return false;
    };
    for (PlacedShape& shape : shapes_) {
        if (shape.lights.empty() && emits(shape)) shape.lights = make_slot_lights(shape, {});
    }
    for (Instance& instance : instances_) {
        const std::vector<PlacedShape>& group = groups_[instance.group];
        for (std::size_t i = 0; i < group.size(); ++i) {
            if (!emits(group[i])) continue;
            instance.lights.resize(group.size());
            instance.lights[i] = make_slot_lights(group[i], instance.world_from_group);
        }
    }
}

std::vector<Sphere> Scene::find_casters() const {
    std::vector<bool> focusing;
    for (const MaterialDesc& material : materials_) focusing.push_back(focuses(material, *textures_));
    std::vector<Sphere> casters = etendue::find_casters(shapes_, focusing);
    std::vector<std::vector<Sphere>> of_group;
    for (const auto& group : groups_) of_group.push_back(etendue::find_casters(group, focusing));
    for (const Instance& instance : instances_) {
        for (const Sphere& sphere : of_group[instance.group]) {
            casters.push_back(transformed(sphere, instance.world_from_group));
        }
    }
    return casters;
}

bool Scene::needs_light_paths() const {
    return std::any_of(lights_.begin(), lights_.end(), [](const auto& light) { return light->delta(); }) &&
           std::any_of(materials_.begin(), materials_.end(),
                       [this](const MaterialDesc& material) { return has_delta_lobe(material, *textures_); });
}

std::optional<SurfaceInteraction> Scene::intersect(const Ray& ray) const {
    const std::optional<AccelHit> hit = accel_->intersect(ray);
    if (!hit) return {};
    if (hit->instance == kNoInstance) {
        const PlacedShape& shape = shapes_[hit->geometry];
        SurfaceInteraction si = interact(*shape.geometry, ray, *hit);
        const auto slot = static_cast<std::size_t>(hit_slot(*shape.geometry, *hit));
        si.material = shape.materials[slot];
        if (!shape.lights.empty()) si.light = shape.lights[slot];
        return si;
    }
    const Instance& instance = instances_[hit->instance];
    const PlacedShape& shape = groups_[instance.group][hit->geometry];
    const Ray local{instance.world_from_group.inverse_point(ray.origin),
                    instance.world_from_group.inverse_vector(ray.direction)};
    SurfaceInteraction si = interact(*shape.geometry, local, *hit);
    to_world(instance.world_from_group, si);
    const auto slot = static_cast<std::size_t>(hit_slot(*shape.geometry, *hit));
    si.material = shape.materials[slot];
    if (!instance.lights.empty() && !instance.lights[hit->geometry].empty()) {
        si.light = instance.lights[hit->geometry][slot];
    }
    return si;
}

MemoryUse Scene::memory_use() const {
    std::set<const PlacedGeometry*> seen;  // groups may share
    MemoryUse use;
    const auto add = [&](const std::vector<PlacedShape>& shapes) {
        for (const PlacedShape& shape : shapes) {
            const auto* mesh = std::get_if<TriangleMesh>(shape.geometry.get());
            if (mesh != nullptr && seen.insert(shape.geometry.get()).second) use.vertices += mesh->memory_used();
        }
    };
    add(shapes_);
    for (const auto& group : groups_) add(group);
    use.acceleration = static_cast<std::size_t>(accel_->memory_used());
    use.lights = light_sampler_->memory_used();
    for (const auto& light : lights_) use.lights += light->memory_used();
    const std::vector<bool>& unused = texture_files_.unused;
    if (std::find(unused.begin(), unused.end(), false) != unused.end()) {
        use.textures = static_cast<std::size_t>(textures_->memory_used());
        use.textures_limit = static_cast<std::size_t>(texture_files_.megabytes * 0x1p20);
    }
    return use;
}

std::optional<PickedSurface> Scene::pick(const Ray& ray) const {
    const std::optional<AccelHit> hit = accel_->intersect(ray);
    if (!hit) return {};
    PickedSurface picked;
    const bool instanced = hit->instance != kNoInstance;
    if (instanced) picked.instance = static_cast<int>(hit->instance);
    if (instanced || shapes_[hit->geometry].placement) picked.shape = static_cast<int>(hit->geometry);
    picked.triangle = static_cast<int>(hit->primitive);
    return picked;
}

bool Scene::visible(const RayEnd& a, const RayEnd& b) const {
    const Vec3 d = b.p - a.p;
    const Vec3 from = offset_origin(a.p, a.p_error, a.n_g, d);
    // Embree knows the far end from the near one: direction, corners relative to the origin, plane and distance, and in
    // an instance the ray itself, are all rounded to float, by some fifteen roundings of the ray's length together.
    const double slack = max_component(abs(d)) * (16 * kFloatRounding);
    const Vec3 to = offset_origin(b.p, b.p_error + Vec3(slack, slack, slack), b.n_g, -d);
    return !accel_->occluded({from, to - from}, 1);
}

bool Scene::sees_infinity(const RayEnd& a, const Vec3& direction) const {
    return !accel_->occluded({offset_origin(a.p, a.p_error, a.n_g, direction), direction}, kInfinity);
}

Vec3 Scene::shading_normal(const SurfaceInteraction& si) const {
    if (!scatters(si)) return si.n_s;
    return etendue::shading_normal(materials_[static_cast<std::size_t>(si.material)], *textures_, si);
}

Rgb Scene::albedo(const SurfaceInteraction& si) const {
    if (!scatters(si)) return {};
    return material_albedo(materials_[static_cast<std::size_t>(si.material)], *textures_, si.st);
}

}  // namespace etendue
