#include "material.h"

#include <pxr/imaging/hd/sceneDelegate.h>

#include "render_param.h"

namespace etendue::hydra {
namespace {

/// Scene indices name nodes relative to their material; warnings name prims.
HdMaterialNetwork2 with_whole_names(const HdMaterialNetwork2& network, const SdfPath& material) {
    HdMaterialNetwork2 out = network;
    out.nodes.clear();
    for (const auto& [name, node] : network.nodes) {
        HdMaterialNode2& renamed = out.nodes[name.MakeAbsolutePath(material)] = node;
        for (auto& [input, connections] : renamed.inputConnections) {
            for (auto& connection : connections) {
                connection.upstreamNode = connection.upstreamNode.MakeAbsolutePath(material);
            }
        }
    }
    for (auto& [name, terminal] : out.terminals) {
        terminal.upstreamNode = terminal.upstreamNode.MakeAbsolutePath(material);
    }
    return out;
}

}  // namespace

void Material::Sync(HdSceneDelegate* delegate, HdRenderParam* param, HdDirtyBits* bits) {
    if (*bits & AllDirty) {
        HdMaterialNetwork2 network;
        const VtValue resource = delegate->GetMaterialResource(GetId());
        if (resource.IsHolding<HdMaterialNetworkMap>()) {
            network =
                with_whole_names(HdConvertToHdMaterialNetwork2(resource.UncheckedGet<HdMaterialNetworkMap>()), GetId());
        }
        ours(param).store().set_material(GetId(), std::move(network));
    }
    *bits = Clean;
}

void Material::Finalize(HdRenderParam* param) { ours(param).store().remove_material(GetId()); }

}  // namespace etendue::hydra
