#pragma once

#include <pxr/imaging/hd/rendererPlugin.h>
#include <pxr/pxr.h>

PXR_NAMESPACE_OPEN_SCOPE

/// The thin half of the plugin, which USD loads and which links to USD alone. It opens the other half, and with it the
/// core library and Embree, so that their symbols are looked up among their own libraries first: Embree's names carry
/// no version, and a host that has loaded Embree 4 would otherwise have our calls, without a word.
class HdEtendueRendererPlugin final : public HdRendererPlugin {
public:
    HdRenderDelegate* CreateRenderDelegate() override;
    HdRenderDelegate* CreateRenderDelegate(const HdRenderSettingsMap& settings) override;
    void DeleteRenderDelegate(HdRenderDelegate* delegate) override;
#if PXR_VERSION >= 2511
    bool IsSupported(const HdRendererCreateArgs& arguments, std::string* reason) const override;
#endif
#if PXR_VERSION < 2608
    bool IsSupported(bool gpu_enabled) const override;
#endif
};

PXR_NAMESPACE_CLOSE_SCOPE
