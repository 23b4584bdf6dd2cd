#pragma once

#include <pxr/imaging/hd/rprim.h>

#include "scene_store.h"
#include "warnings.h"

namespace etendue::hydra {

/// Sphere, cube, cylinder, cone, capsule or plane, exact: where a host's scene index hands over implicit surfaces.
/// Hosts without scene indices hand over coarse meshes instead, and nothing tells that they are meant round.
class Implicit final : public HdRprim {
public:
    Implicit(const SdfPath& path, TfToken type) : HdRprim(path), type_(std::move(type)) {}

    [[nodiscard]] HdDirtyBits GetInitialDirtyBitsMask() const override;
    [[nodiscard]] const TfTokenVector& GetBuiltinPrimvarNames() const override;
    void Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits, const TfToken& repr) override;
    void UpdateRenderTag(HdSceneDelegate* delegate, HdRenderParam* param) override;
    void Finalize(HdRenderParam* param) override;

    /// The types of prim that an Implicit can be.
    [[nodiscard]] static const TfTokenVector& types();

protected:
    [[nodiscard]] HdDirtyBits _PropagateDirtyBits(HdDirtyBits bits) const override { return bits; }
    void _InitRepr(const TfToken& /*repr*/, HdDirtyBits* /*bits*/) override {}

private:
    [[nodiscard]] std::shared_ptr<const Geometry> read_geometry(HdSceneDelegate& delegate, Warnings& warnings) const;

    TfToken type_;
    ShapeRecord record_;
};

}  // namespace etendue::hydra
