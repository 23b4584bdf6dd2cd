#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <etendue/scene_description.h>

#include <pxr/base/gf/matrix4d.h>
#include <pxr/base/tf/token.h>
#include <pxr/base/vt/array.h>
#include <pxr/base/vt/types.h>
#include <pxr/imaging/hd/material.h>
#include <pxr/usd/sdf/path.h>

#include "geometry.h"
#include "usd.h"

namespace etendue::hydra {

/// How a mesh light and its material go together (UsdLux's materialSyncMode).
enum class MaterialSync { NoResponse, GlowTintsLight, Independent };

/// A mesh that emits light of its own.
struct MeshLight {
    LightDesc desc;  ///< without its shape
    MaterialSync sync = MaterialSync::GlowTintsLight;
};

struct ShapeRecord {
    int prim_id = -1;                          ///< Hydra's, for picking
    std::shared_ptr<const Geometry> geometry;  ///< null: nothing that can be rendered
    SdfPath material;                          ///< empty: displayColor
    std::optional<Color> display_color;
    double display_opacity = 1;
    GfMatrix4d transform{1.0};
    bool visible = true;
    TfToken render_tag;
    bool instanced = false;
    VtMatrix4dArray instances;  ///< world from the instanced prim's own world
    std::optional<MeshLight> light;
};

struct LightRecord {
    LightDesc desc;  ///< without its transform
    GfMatrix4d transform{1.0};
    bool visible = true;
    bool instanced = false;
    VtMatrix4dArray instances;  ///< as of a shape
};

/// The scene as Hydra's prims have told it, by path. Renders read a copy, so prims may be edited while one runs; every
/// edit makes a new version. May be called from several threads.
class SceneStore {
public:
    void set_shape(const SdfPath& path, ShapeRecord record);
    /// Of a shape that is there.
    void set_render_tag(const SdfPath& path, const TfToken& tag);
    void set_light(const SdfPath& path, LightRecord record);
    void set_material(const SdfPath& path, HdMaterialNetwork2 network);
    void remove_shape(const SdfPath& path);
    void remove_light(const SdfPath& path);
    void remove_material(const SdfPath& path);

    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// Makes a new version of the same scene, which is rendered anew.
    void touch() { ++version_; }

    /// Copies, which share the geometry.
    struct Contents {
        std::map<SdfPath, ShapeRecord> shapes;
        std::map<SdfPath, LightRecord> lights;
        std::map<SdfPath, HdMaterialNetwork2> materials;
        std::uint64_t version = 0;
    };
    [[nodiscard]] Contents contents() const;

private:
    mutable std::mutex mutex_;
    Contents contents_;
    std::atomic<std::uint64_t> version_{1};
};

}  // namespace etendue::hydra
