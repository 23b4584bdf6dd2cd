#include "warnings.h"

#include <pxr/base/tf/diagnostic.h>

namespace etendue::hydra {

void Warnings::warn(const std::string& kind, const SdfPath& path, const std::string& message) {
    {
        const std::lock_guard lock(mutex_);
        if (!told_.insert(kind).second) return;
    }
    TF_WARN("Etendue: <%s>: %s", path.GetText(), message.c_str());
}

}  // namespace etendue::hydra
