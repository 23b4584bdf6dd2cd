#pragma once

#include <string>

#include <pxr/imaging/hd/renderDelegate.h>

#include "usd.h"

namespace etendue::hydra {

/// The plugin's other half, open for as long as the process lives: USD keeps plugins.
struct DelegateLibrary {
    HdRenderDelegate* (*create)(const HdRenderSettingsMap&) = nullptr;
    void (*destroy)(HdRenderDelegate*) = nullptr;
    std::string complaint;  ///< why it cannot be used; empty when it can
};

[[nodiscard]] const DelegateLibrary& delegate_library();

}  // namespace etendue::hydra
