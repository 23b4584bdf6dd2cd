#pragma once

#include <pxr/imaging/hd/mesh.h>

#include "scene_store.h"

namespace etendue::hydra {

/// A mesh, with the materials of its subsets and its instances.
class Mesh final : public HdMesh {
public:
    explicit Mesh(const SdfPath& path) : HdMesh(path) {}

    [[nodiscard]] HdDirtyBits GetInitialDirtyBitsMask() const override;
    void Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits, const TfToken& repr) override;
    void UpdateRenderTag(HdSceneDelegate* delegate, HdRenderParam* param) override;
    void Finalize(HdRenderParam* param) override;

protected:
    [[nodiscard]] HdDirtyBits _PropagateDirtyBits(HdDirtyBits bits) const override { return bits; }
    void _InitRepr(const TfToken& /*repr*/, HdDirtyBits* /*bits*/) override {}

private:
    ShapeRecord record_;
};

}  // namespace etendue::hydra
