#include "renderer_plugin.h"

#include <pxr/base/tf/diagnostic.h>
#include <pxr/imaging/hd/rendererPluginRegistry.h>

#include "delegate_library.h"

PXR_NAMESPACE_OPEN_SCOPE

TF_REGISTRY_FUNCTION(TfType) { HdRendererPluginRegistry::Define<HdEtendueRendererPlugin>(); }

HdRenderDelegate* HdEtendueRendererPlugin::CreateRenderDelegate() { return CreateRenderDelegate({}); }

HdRenderDelegate* HdEtendueRendererPlugin::CreateRenderDelegate(const HdRenderSettingsMap& settings) {
    const etendue::hydra::DelegateLibrary& library = etendue::hydra::delegate_library();
    if (library.complaint.empty()) return library.create(settings);
    TF_RUNTIME_ERROR("Etendue: %s", library.complaint.c_str());
    return nullptr;
}

void HdEtendueRendererPlugin::DeleteRenderDelegate(HdRenderDelegate* delegate) {
    if (delegate != nullptr) etendue::hydra::delegate_library().destroy(delegate);
}

#if PXR_VERSION >= 2511
bool HdEtendueRendererPlugin::IsSupported(const HdRendererCreateArgs& /*arguments*/, std::string* reason) const {
    const std::string& complaint = etendue::hydra::delegate_library().complaint;
    if (reason != nullptr) *reason = complaint;
    return complaint.empty();
}
#endif
#if PXR_VERSION < 2608
bool HdEtendueRendererPlugin::IsSupported(bool /*gpu_enabled*/) const {
    return etendue::hydra::delegate_library().complaint.empty();
}
#endif

PXR_NAMESPACE_CLOSE_SCOPE
