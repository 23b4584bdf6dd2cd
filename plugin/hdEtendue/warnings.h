#pragma once

#include <mutex>
#include <set>
#include <string>

#include <pxr/usd/sdf/path.h>

#include "usd.h"

namespace etendue::hydra {

/// What a scene asks for and Etendue does not do, told once per kind as the stage reader tells it: hosts translate a
/// scene again and again. May be called from several threads, as Hydra syncs prims.
class Warnings {
public:
    /// Issues a TF_WARN that names `path` when `kind` is new.
    void warn(const std::string& kind, const SdfPath& path, const std::string& message);

private:
    std::mutex mutex_;
    std::set<std::string> told_;
};

}  // namespace etendue::hydra
