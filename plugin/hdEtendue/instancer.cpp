#include "instancer.h"

#include <pxr/base/gf/matrix4d.h>
#include <pxr/base/gf/quatd.h>
#include <pxr/base/gf/quatf.h>
#include <pxr/base/gf/quath.h>
#include <pxr/base/gf/vec3d.h>
#include <pxr/base/gf/vec3f.h>
#include <pxr/base/gf/vec4f.h>
#include <pxr/base/vt/array.h>
#include <pxr/imaging/hd/tokens.h>

#include "convert.h"

namespace etendue::hydra {
namespace {

template <class Quaternion>
VtArray<GfQuatd> quaternions_as(const VtValue& value) {
    VtArray<GfQuatd> out;
    for (const Quaternion& q : value.UncheckedGet<VtArray<Quaternion>>().AsConst()) out.push_back(GfQuatd(q));
    return out;
}

VtArray<GfQuatd> quaternions(const VtValue& value) {
    if (value.IsHolding<VtQuathArray>()) return quaternions_as<GfQuath>(value);
    if (value.IsHolding<VtQuatfArray>()) return quaternions_as<GfQuatf>(value);
    VtArray<GfQuatd> out;
    if (value.IsHolding<VtVec4fArray>()) {  // real part first
        for (const GfVec4f& q : value.UncheckedGet<VtVec4fArray>().AsConst()) out.emplace_back(q[0], q[1], q[2], q[3]);
    }
    return out;
}

GfVec3d vector_at(const std::vector<Float3>& values, std::size_t i) {
    return {values[i][0], values[i][1], values[i][2]};
}

/// What places one instance, in the order of row vectors: transform, scale, rotation, translation.
class Placements {
public:
    Placements(HdSceneDelegate& delegate, const SdfPath& path)
        : translations_(vectors<3>(delegate.Get(path, HdInstancerTokens->instanceTranslations))),
          scales_(vectors<3>(delegate.Get(path, HdInstancerTokens->instanceScales))),
          rotations_(quaternions(delegate.Get(path, HdInstancerTokens->instanceRotations))),
          transforms_(delegate.Get(path, HdInstancerTokens->instanceTransforms).GetWithDefault<VtMatrix4dArray>()) {}

    [[nodiscard]] GfMatrix4d at(std::size_t i) const {
        GfMatrix4d placement(1);
        if (i < transforms_.size()) placement = transforms_[i];
        if (i < scales_.size()) placement *= GfMatrix4d(1).SetScale(vector_at(scales_, i));
        if (i < rotations_.size()) placement *= GfMatrix4d(1).SetRotate(rotations_[i].GetNormalized());
        if (i < translations_.size()) placement *= GfMatrix4d(1).SetTranslate(vector_at(translations_, i));
        return placement;
    }

private:
    std::vector<Float3> translations_;
    std::vector<Float3> scales_;
    VtArray<GfQuatd> rotations_;
    VtMatrix4dArray transforms_;
};

}  // namespace

void Instancer::Sync(HdSceneDelegate* delegate, HdRenderParam* /*param*/, HdDirtyBits* bits) {
    _UpdateInstancer(delegate, bits);
}

VtMatrix4dArray Instancer::transforms(const SdfPath& prototype) {
    HdSceneDelegate& delegate = *GetDelegate();
    if (!delegate.GetVisible(GetId())) return {};  // prototypes of scene indices are visible whatever it is
    const GfMatrix4d own = delegate.GetInstancerTransform(GetId());
    const Placements placements(delegate, GetId());
    VtMatrix4dArray parents(1, GfMatrix4d(1));
    if (!GetParentId().IsEmpty()) parents = instance_transforms(delegate.GetRenderIndex(), GetParentId(), GetId());
    VtMatrix4dArray out;
    for (const GfMatrix4d& parent : parents.AsConst()) {
        for (const int index : delegate.GetInstanceIndices(GetId(), prototype)) {
            out.push_back(placements.at(static_cast<std::size_t>(index)) * own * parent);
        }
    }
    return out;
}

VtMatrix4dArray instance_transforms(HdRenderIndex& index, const SdfPath& path, const SdfPath& prototype) {
    auto* const instancer = static_cast<Instancer*>(index.GetInstancer(path));
    return instancer == nullptr ? VtMatrix4dArray() : instancer->transforms(prototype);
}

}  // namespace etendue::hydra
