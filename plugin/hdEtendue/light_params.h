#pragma once

#include <optional>

#include <pxr/base/vt/value.h>
#include <pxr/imaging/hd/sceneDelegate.h>

#include "scene_store.h"
#include "warnings.h"

namespace etendue::hydra {

/// The light that a mesh is, if it is one.
[[nodiscard]] std::optional<MeshLight> read_mesh_light(HdSceneDelegate& delegate, Warnings& warnings,
                                                       const SdfPath& path);

/// The parameters of one light prim by UsdLux's names.
class LightParams {
public:
    LightParams(HdSceneDelegate& delegate, Warnings& warnings, const SdfPath& path)
        : delegate_(delegate), warnings_(warnings), path_(path) {}

    /// Fills everything but size and transform: emission and shaping.
    void fill_emission(LightDesc& desc) const;
    /// The size that the kind of light has, and its texture.
    void fill_size(LightDesc& desc) const;
    /// One warning for each thing authored that is not supported.
    void warn_unsupported() const;

    [[nodiscard]] VtValue value(const char* name) const;
    [[nodiscard]] double number(const char* name, double fallback) const;

private:
    void fill_texture(LightDesc& desc) const;
    void fill_shaping(LightDesc& desc) const;
    void warn(const std::string& kind, const std::string& message) const;

    HdSceneDelegate& delegate_;
    Warnings& warnings_;
    SdfPath path_;
};

}  // namespace etendue::hydra
