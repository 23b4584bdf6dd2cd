#include "scene_store.h"

#include <utility>

namespace etendue::hydra {

void SceneStore::set_shape(const SdfPath& path, ShapeRecord record) {
    const std::lock_guard lock(mutex_);
    contents_.shapes[path] = std::move(record);
    ++version_;
}

void SceneStore::set_render_tag(const SdfPath& path, const TfToken& tag) {
    const std::lock_guard lock(mutex_);
    const auto shape = contents_.shapes.find(path);
    if (shape == contents_.shapes.end() || shape->second.render_tag == tag) return;
    shape->second.render_tag = tag;
    ++version_;
}

void SceneStore::set_light(const SdfPath& path, LightRecord record) {
    const std::lock_guard lock(mutex_);
    contents_.lights[path] = std::move(record);
    ++version_;
}

void SceneStore::set_material(const SdfPath& path, HdMaterialNetwork2 network) {
    const std::lock_guard lock(mutex_);
    contents_.materials[path] = std::move(network);
    ++version_;
}

void SceneStore::remove_shape(const SdfPath& path) {
    const std::lock_guard lock(mutex_);
    if (contents_.shapes.erase(path) > 0) ++version_;
}

void SceneStore::remove_light(const SdfPath& path) {
    const std::lock_guard lock(mutex_);
    if (contents_.lights.erase(path) > 0) ++version_;
}

void SceneStore::remove_material(const SdfPath& path) {
    const std::lock_guard lock(mutex_);
    if (contents_.materials.erase(path) > 0) ++version_;
}

SceneStore::Contents SceneStore::contents() const {
    const std::lock_guard lock(mutex_);
    Contents copy = contents_;
    copy.version = version_;
    return copy;
}

}  // namespace etendue::hydra
