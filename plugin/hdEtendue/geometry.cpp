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

std::shared_ptr<const Geometry> Geometry::kept(std::shared_ptr<const Geometry> before,
                                               std::shared_ptr<const Geometry> now) {
    const bool same = before && now && before->same_as(*now);
    return same ? before : now;
}

bool Geometry::same_as(const Geometry& other) const {
    if (coordinates != other.coordinates || subset_materials != other.subset_materials || faces != other.faces) {
        return false;
    }
    return *shape() == *other.with_coordinates(current_name());
}

std::string Geometry::current_name() const {
    const std::lock_guard lock(mutex_);
    return has_;
}

}  // namespace etendue::hydra
