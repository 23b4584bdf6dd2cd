#include "texture_files.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <mutex>
#include <system_error>

#include <unistd.h>

#include <pxr/usd/ar/asset.h>
#include <pxr/usd/ar/packageUtils.h>
#include <pxr/usd/ar/resolvedPath.h>
#include <pxr/usd/ar/resolver.h>
#include <pxr/usd/sdf/assetPath.h>

namespace etendue::hydra {
namespace {

/// A directory for files taken out of packages: made on first use, removed when the plugin is.
class Scratch {
public:
    Scratch() = default;
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() {
        std::error_code ignored;
        if (!directory_.empty()) std::filesystem::remove_all(directory_, ignored);
    }

    /// The copy of the package's file `resolved`; empty when it cannot be made.
    std::string extract(const std::string& resolved) {
        const std::lock_guard lock(mutex_);
        if (directory_.empty()) {
            std::string name = (std::filesystem::temp_directory_path() / "etendue-XXXXXX").string();
            if (::mkdtemp(name.data()) == nullptr) return {};
            directory_ = name;
        }
        const std::string inner = ArSplitPackageRelativePathInner(resolved).second;
        const std::filesystem::path file = directory_ / (std::to_string(std::hash<std::string>()(resolved)) + "-" +
                                                         std::filesystem::path(inner).filename().string());
        if (!std::filesystem::exists(file) && !copy(resolved, file)) return {};
        return file.string();
    }

private:
    static bool copy(const std::string& resolved, const std::filesystem::path& file) {
        const std::shared_ptr<ArAsset> asset = ArGetResolver().OpenAsset(ArResolvedPath(resolved));
        if (!asset) return false;
        const std::shared_ptr<const char> buffer = asset->GetBuffer();
        std::ofstream out(file, std::ios::binary);
        return buffer && out.write(buffer.get(), static_cast<std::streamsize>(asset->GetSize())).good();
    }

    std::mutex mutex_;
    std::filesystem::path directory_;
};

Scratch& scratch() {
    static Scratch instance;
    return instance;
}

std::string resolved_name(const VtValue& asset) {
    if (asset.IsHolding<std::string>()) return asset.UncheckedGet<std::string>();
    if (!asset.IsHolding<SdfAssetPath>()) return {};
    const auto& path = asset.UncheckedGet<SdfAssetPath>();
    return path.GetResolvedPath().empty() ? path.GetAssetPath() : path.GetResolvedPath();
}

bool is_there(const std::string& name) {
    // A set of tiles has no file of its own name; the core names the tiles it misses.
    std::error_code ignored;
    return name.find("<UDIM>") != std::string::npos || std::filesystem::exists(name, ignored);
}

}  // namespace

std::optional<std::string> texture_file(Warnings& warnings, const SdfPath& path, const VtValue& asset,
                                        const std::string& stand_in) {
    const std::string name = resolved_name(asset);
    if (name.empty()) {
        warnings.warn("texture without file " + path.GetString(), path,
                      "the texture names no file; " + stand_in + " is used");
        return std::nullopt;
    }
    const std::string file = ArIsPackageRelativePath(name) ? scratch().extract(name) : name;
    if (!file.empty() && is_there(file)) return file;
    warnings.warn("missing texture " + name, path,
                  "texture file '" + name + "' is not found; " + stand_in + " is used");
    return std::nullopt;
}

}  // namespace etendue::hydra
