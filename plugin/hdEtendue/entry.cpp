#include "entry.h"

#include "render_delegate.h"

PXR_NS::HdRenderDelegate* etendue_hydra_create(const PXR_NS::HdRenderSettingsMap& settings) {
    return new etendue::hydra::RenderDelegate(settings);
}

void etendue_hydra_delete(PXR_NS::HdRenderDelegate* delegate) { delete delegate; }
