#pragma once

#include <pxr/imaging/hd/renderDelegate.h>

/// What the plugin's thin half finds in its other half by name.
extern "C" {
__attribute__((visibility("default"))) PXR_NS::HdRenderDelegate* etendue_hydra_create(
    const PXR_NS::HdRenderSettingsMap& settings);
__attribute__((visibility("default"))) void etendue_hydra_delete(PXR_NS::HdRenderDelegate* delegate);
}
