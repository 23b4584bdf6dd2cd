#include "assemble.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "convert.h"
#include "materials.h"
#include "translation.h"

namespace etendue::hydra {
namespace {

/// One set of texture coordinates for the whole shape: the first that its materials name and the mesh has.
std::string chosen_st(const std::vector<BoundMaterial>& materials, const Geometry& geometry, const std::string& path,
                      Warnings& warnings) {
    std::set<std::string> names;
    std::string chosen;
    for (const BoundMaterial& material : materials) {
        if (!geometry.coordinates.contains(material.st) || !names.insert(material.st).second) continue;
        if (chosen.empty()) chosen = material.st;
    }
    if (names.size() > 1) {
        warnings.warn("several texture coordinates on a mesh", SdfPath(path),
                      "its materials read several texture coordinates; '" + chosen + "' is used for all");
    }
    return chosen;
}

class Assembler {
public:
    Assembler(Assembled& out, const SceneStore::Contents& contents, Warnings& warnings)
        : scene_(out.scene),
          prims_(out.prims),
          warnings_(warnings),
          materials_({out.scene, warnings}, contents.materials) {}

    void add(const SdfPath& path, const ShapeRecord& record) {
        if (!places(path, record.transform)) return;
        ShapeDesc shape = describe(path, record, bind(record));
        if (!record.instanced) {
            scene_.shapes.push_back(std::move(shape));
            prims_.shapes.push_back({record.prim_id, record.geometry});
            return;
        }
        const std::size_t group = scene_.groups.size();
        scene_.groups.push_back({shape.name, {shape}});
        prims_.groups.push_back({record.prim_id, record.geometry});
        int number = 0;
        for (const GfMatrix4d& transform : record.instances.AsConst()) {
            if (places(path, transform)) {
                scene_.instances.push_back({shape.name, static_cast<int>(group), column_matrix(transform)});
                prims_.instances.push_back({group, number});
            }
            ++number;
        }
    }

    /// Once for each of its instances: a light is one place in the world.
    void add_light(const SdfPath& path, const LightRecord& record) {
        const auto add_at = [&](const GfMatrix4d& transform) {
            if (!places(path, transform)) return;
            scene_.lights.push_back(record.desc);
            scene_.lights.back().world_from_light = column_matrix(transform);
        };
        if (!record.instanced) return add_at(record.transform);
        for (const GfMatrix4d& transform : record.instances.AsConst()) add_at(record.transform * transform);
    }

    void add_light(const SdfPath& path, const ShapeRecord& record) {
        const ShapeDesc shape = describe(path, record, bind_light(path, record));
        const auto add_at = [&](const GfMatrix4d& transform) {
            if (!places(path, transform)) return;
            add_light(shape, *record.light, transform);
            prims_.shapes.push_back({record.prim_id, record.geometry});
        };
        if (!record.instanced) return add_at(record.transform);
        for (const GfMatrix4d& transform : record.instances.AsConst()) add_at(record.transform * transform);
    }

private:
    /// Core refuses a scene for one such matrix; scales of zero are how some hosts hide things.
    bool places(const SdfPath& path, const GfMatrix4d& transform) {
        if (is_placement(column_matrix(transform))) return true;
        warnings_.warn("transform " + path.GetString(), path,
                       "its transform is singular or not finite; it is left out");
        return false;
    }

    void add_light(ShapeDesc shape, const MeshLight& light, const GfMatrix4d& transform) {
        LightDesc desc = light.desc;
        desc.shape = static_cast<int>(scene_.shapes.size());
        desc.world_from_light = column_matrix(transform);
        shape.parent_from_object = desc.world_from_light;
        scene_.shapes.push_back(std::move(shape));
        scene_.lights.push_back(std::move(desc));
    }

    ShapeDesc describe(const SdfPath& path, const ShapeRecord& record, const std::vector<BoundMaterial>& bound) {
        ShapeDesc shape;
        shape.name = path.GetString();
        shape.parent_from_object = column_matrix(record.transform);
        for (const BoundMaterial& material : bound) shape.materials.push_back(material.index);
        shape.geometry = static_cast<int>(scene_.geometries.size());
        scene_.geometries.push_back(
            record.geometry->with_coordinates(chosen_st(bound, *record.geometry, shape.name, warnings_)));
        return shape;
    }

    std::vector<BoundMaterial> bind(const ShapeRecord& record) {
        std::vector<BoundMaterial> bound{materials_.bound(record.material, record)};
        const auto& subsets = record.geometry->subset_materials;
        for (std::size_t i = 1; i < subsets.size(); ++i) bound.push_back(materials_.bound(subsets[i], record));
        return bound;
    }

    std::vector<BoundMaterial> bind_light(const SdfPath& path, const ShapeRecord& record) {
        std::vector<BoundMaterial> bound = bind(record);
        const auto emits = [](const BoundMaterial& material) { return material.emits; };
        if (record.light->sync == MaterialSync::NoResponse) {
            bound.assign(bound.size(), materials_.black());
        } else if (record.light->desc.tinted_by_material && std::none_of(bound.begin(), bound.end(), emits)) {
            warnings_.warn("mesh light without glow", path,
                           "materialGlowTintsLight multiplies the light by its material's emission, which is black: "
                           "it emits nothing");
        }
        return bound;
    }

    SceneDescription& scene_;
    PrimTable& prims_;
    Warnings& warnings_;
    MaterialTranslator materials_;
};

/// All lights in the order of paths: first those that are shapes, as far as they come before `path`.
void add_mesh_lights_before(const SdfPath* path, std::map<SdfPath, const ShapeRecord*>& waiting, Assembler& assembler) {
    while (!waiting.empty() && (path == nullptr || waiting.begin()->first < *path)) {
        const auto first = waiting.begin();
        assembler.add_light(first->first, *first->second);
        waiting.erase(first);
    }
}

}  // namespace

bool Selection::includes(const SdfPath& path, const TfToken& render_tag) const {
    const auto below = [&path](const SdfPath& root) { return path.HasPrefix(root); };
    if (!render_tags.empty() && std::find(render_tags.begin(), render_tags.end(), render_tag) == render_tags.end()) {
        return false;
    }
    return std::any_of(roots.begin(), roots.end(), below) && std::none_of(excluded.begin(), excluded.end(), below);
}

Assembled assemble(const SceneStore::Contents& contents, const Selection& selection, Warnings& warnings) {
    Assembled out;
    Assembler assembler(out, contents, warnings);
    std::map<SdfPath, const ShapeRecord*> mesh_lights;
    for (const auto& [path, record] : contents.shapes) {
        if (!record.visible || !record.geometry || !selection.includes(path, record.render_tag)) continue;
        if (record.light) {
            mesh_lights[path] = &record;
        } else {
            assembler.add(path, record);
        }
    }
    for (const auto& [path, record] : contents.lights) {
        if (!record.visible) continue;
        add_mesh_lights_before(&path, mesh_lights, assembler);
        assembler.add_light(path, record);
    }
    add_mesh_lights_before(nullptr, mesh_lights, assembler);
    return out;
}

}  // namespace etendue::hydra
