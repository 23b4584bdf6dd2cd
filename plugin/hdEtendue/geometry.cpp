#include "geometry.h"

#include <variant>

namespace etendue::hydra {

SharedGeometry Geometry::with_coordinates(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    const auto found = coordinates.find(name);
    const std::string wanted = found == coordinates.end() ? "" : name;
    const auto* const mesh = std::get_if<MeshDesc>(&*shape_);
    if (wanted == has_ || mesh == nullptr) return shape_;
    MeshDesc changed = *mesh;
    changed.st.clear();
    if (found != coordinates.end()) {
        changed.st = found->second.values;
        changed.st_interpolation = found->second.interpolation;
    }
    shape_ = std::move(changed);
    has_ = wanted;
    return shape_;
}

SharedGeometry Geometry::shape() const {
    const std::lock_guard lock(mutex_);
    return shape_;
}

}  // namespace etendue::hydra
