#pragma once

#include <pxr/imaging/hd/rprim.h>

#include "usd.h"

namespace etendue::hydra {

/// A kind of prim that Etendue does not render: it says so instead of being missing without a word.
class Unsupported final : public HdRprim {
public:
    Unsupported(const SdfPath& path, TfToken type) : HdRprim(path), type_(std::move(type)) {}

    [[nodiscard]] HdDirtyBits GetInitialDirtyBitsMask() const override;
    [[nodiscard]] const TfTokenVector& GetBuiltinPrimvarNames() const override;
    void Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits, const TfToken& repr) override;

    [[nodiscard]] static const TfTokenVector& types();

protected:
    [[nodiscard]] HdDirtyBits _PropagateDirtyBits(HdDirtyBits bits) const override { return bits; }
    void _InitRepr(const TfToken& /*repr*/, HdDirtyBits* /*bits*/) override {}

private:
    TfToken type_;
};

}  // namespace etendue::hydra
