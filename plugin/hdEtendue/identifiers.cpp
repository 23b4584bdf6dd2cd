#include "identifiers.h"

#include <map>
#include <optional>
#include <variant>

namespace etendue::hydra {
namespace {

using Shape = PrimTable::Shape;

/// The authored face of each triangle; empty for an exact surface.
std::vector<std::int32_t> faces_of_triangles(const Geometry& geometry) {
    std::vector<std::int32_t> faces;
    const SharedGeometry shape = geometry.shape();
    const auto* const mesh = std::get_if<MeshDesc>(&*shape);
    if (mesh == nullptr) return faces;
    for (std::size_t face = 0; face < mesh->face_vertex_counts.size(); ++face) {
        const std::int32_t authored = geometry.faces.empty() ? static_cast<std::int32_t>(face) : geometry.faces[face];
        faces.insert(faces.end(), static_cast<std::size_t>(mesh->face_vertex_counts[face] - 2), authored);
    }
    return faces;
}

const Shape* shape_of(const PickedSurface& picked, const PrimTable& table) {
    if (picked.shape < 0) return nullptr;
    if (picked.instance < 0) return &table.shapes[static_cast<std::size_t>(picked.shape)];
    return &table.groups[table.instances[static_cast<std::size_t>(picked.instance)].group];
}

using Picture = std::vector<std::optional<PickedSurface>>;

Picture pick(const RenderSession& session, const PixelWindow& window, const std::function<bool()>& is_stale) {
    Picture picked;
    for (int y = window.y0; y < window.y1; ++y) {
        if (is_stale()) return {};
        for (int x = window.x0; x < window.x1; ++x) picked.push_back(session.pick(x + 0.5, y + 0.5));
    }
    return picked;
}

}  // namespace

Identifiers identify(const RenderSession& session, const PixelWindow& window, const PrimTable& table,
                     const std::function<bool()>& is_stale) {
    const Picture picked = pick(session, window, is_stale);
    std::map<const Geometry*, std::vector<std::int32_t>> faces;
    Identifiers out;
    for (std::vector<std::int32_t>* ids : {&out.prims, &out.instances, &out.elements}) ids->assign(picked.size(), -1);
    for (std::size_t i = 0; i < picked.size(); ++i) {
        const Shape* const shape = picked[i] ? shape_of(*picked[i], table) : nullptr;
        if (shape == nullptr) continue;
        const auto [known, added] = faces.try_emplace(shape->geometry.get());
        if (added) known->second = faces_of_triangles(*shape->geometry);
        const int instance = picked[i]->instance;
        out.prims[i] = shape->prim_id;
        out.instances[i] = instance < 0 ? 0 : table.instances[static_cast<std::size_t>(instance)].number;
        out.elements[i] = known->second.empty() ? 0 : known->second[static_cast<std::size_t>(picked[i]->triangle)];
    }
    return out;
}

}  // namespace etendue::hydra
