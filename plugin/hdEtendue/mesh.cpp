#include "mesh.h"

#include <pxr/imaging/hd/changeTracker.h>
#include <pxr/imaging/hd/sceneDelegate.h>

#include "light_params.h"
#include "mesh_geometry.h"
#include "render_param.h"
#include "shape_sync.h"

namespace etendue::hydra {
namespace {

constexpr HdDirtyBits kGeometryBits = HdChangeTracker::DirtyTopology | HdChangeTracker::DirtyPoints |
                                      HdChangeTracker::DirtyNormals | HdChangeTracker::DirtyPrimvar |
                                      HdChangeTracker::DirtySubdivTags;

}  // namespace

HdDirtyBits Mesh::GetInitialDirtyBitsMask() const {
    return HdChangeTracker::InitRepr | HdChangeTracker::DirtyTransform | HdChangeTracker::DirtyVisibility |
           HdChangeTracker::DirtyMaterialId | HdChangeTracker::DirtyInstancer | HdChangeTracker::DirtyInstanceIndex |
           HdChangeTracker::DirtyRenderTag | kGeometryBits;
}

void Mesh::Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits, const TfToken& /*repr*/) {
    RenderParam& shared = ours(param);
    _UpdateVisibility(delegate, bits);
    _UpdateInstancer(delegate, bits);
    if (*bits & kGeometryBits) {
        const auto primvars = read_primvars(*delegate, GetId());
        record_.geometry =
            Geometry::kept(record_.geometry, read_mesh_geometry(shared.warnings(), *delegate, GetId(), primvars));
        sync_display(shared.warnings(), GetId(), primvars, record_);
        record_.light = read_mesh_light(*delegate, shared.warnings(), GetId());
    }
    sync_shape(*delegate, *this, *bits, record_);
    shared.store().set_shape(GetId(), record_);
    *bits &= ~HdChangeTracker::AllSceneDirtyBits;
}

/// Hydra does not sync prims whose tag nobody shows, but tells all of them their tags.
void Mesh::UpdateRenderTag(HdSceneDelegate* delegate, HdRenderParam* param) {
    HdMesh::UpdateRenderTag(delegate, param);
    record_.render_tag = GetRenderTag();
    ours(param).store().set_render_tag(GetId(), record_.render_tag);
}

void Mesh::Finalize(HdRenderParam* param) { ours(param).store().remove_shape(GetId()); }

}  // namespace etendue::hydra
