#pragma once

#include <pxr/imaging/hd/bprim.h>
#include <pxr/imaging/hd/instancer.h>
#include <pxr/imaging/hd/renderDelegate.h>
#include <pxr/imaging/hd/rprim.h>
#include <pxr/imaging/hd/sprim.h>

#include "render_param.h"

namespace etendue::hydra {

/// Etendue as Hydra sees it: makes prims, buffers and render passes, and says what there is to set.
class RenderDelegate final : public HdRenderDelegate {
public:
    explicit RenderDelegate(const HdRenderSettingsMap& settings);

    [[nodiscard]] const TfTokenVector& GetSupportedRprimTypes() const override;
    [[nodiscard]] const TfTokenVector& GetSupportedSprimTypes() const override;
    [[nodiscard]] const TfTokenVector& GetSupportedBprimTypes() const override;
    [[nodiscard]] HdRenderParam* GetRenderParam() const override { return &param_; }
    [[nodiscard]] HdResourceRegistrySharedPtr GetResourceRegistry() const override { return registry_; }

    [[nodiscard]] HdRenderSettingDescriptorList GetRenderSettingDescriptors() const override { return descriptors_; }
    [[nodiscard]] TfTokenVector GetRenderSettingsNamespaces() const override;
    [[nodiscard]] VtDictionary GetRenderStats() const override;

    [[nodiscard]] bool IsPauseSupported() const override { return true; }
    [[nodiscard]] bool IsPaused() const override;
    bool Pause() override;
    bool Resume() override;
    [[nodiscard]] bool IsStopSupported() const override { return true; }
    [[nodiscard]] bool IsStopped() const override;
    bool Stop(bool blocking) override;
    bool Restart() override;

    HdRenderPassSharedPtr CreateRenderPass(HdRenderIndex* index, const HdRprimCollection& collection) override;
    HdInstancer* CreateInstancer(HdSceneDelegate* delegate, const SdfPath& path) override;
    void DestroyInstancer(HdInstancer* instancer) override { delete instancer; }
    HdRprim* CreateRprim(const TfToken& type, const SdfPath& path) override;
    void DestroyRprim(HdRprim* rprim) override { delete rprim; }
    HdSprim* CreateSprim(const TfToken& type, const SdfPath& path) override;
    HdSprim* CreateFallbackSprim(const TfToken& type) override;
    void DestroySprim(HdSprim* sprim) override { delete sprim; }
    HdBprim* CreateBprim(const TfToken& type, const SdfPath& path) override;
    HdBprim* CreateFallbackBprim(const TfToken& type) override;
    void DestroyBprim(HdBprim* bprim) override { delete bprim; }
    void CommitResources(HdChangeTracker* /*tracker*/) override {}

    [[nodiscard]] TfToken GetMaterialBindingPurpose() const override;
    [[nodiscard]] TfTokenVector GetMaterialRenderContexts() const override;
    [[nodiscard]] HdAovDescriptor GetDefaultAovDescriptor(const TfToken& name) const override;

private:
    mutable RenderParam param_;
    HdResourceRegistrySharedPtr registry_;
    HdRenderSettingDescriptorList descriptors_;
};

}  // namespace etendue::hydra
