#include "unsupported.h"

#include <pxr/imaging/hd/changeTracker.h>
#include <pxr/imaging/hd/tokens.h>

#include "render_param.h"

namespace etendue::hydra {

const TfTokenVector& Unsupported::types() {
    static const TfTokenVector all{HdPrimTypeTokens->basisCurves, HdPrimTypeTokens->points, HdPrimTypeTokens->volume};
    return all;
}

HdDirtyBits Unsupported::GetInitialDirtyBitsMask() const {
    return HdChangeTracker::InitRepr | HdChangeTracker::DirtyRenderTag;
}

const TfTokenVector& Unsupported::GetBuiltinPrimvarNames() const {
    static const TfTokenVector none;
    return none;
}

void Unsupported::Sync(HdSceneDelegate* /*delegate*/, HdRenderParam* param, HdDirtyBits* bits,
                       const TfToken& /*repr*/) {
    ours(param).warnings().warn("gprim " + type_.GetString(), GetId(),
                                type_.GetString() + " is not supported; skipped");
    *bits &= ~HdChangeTracker::AllSceneDirtyBits;
}

}  // namespace etendue::hydra
