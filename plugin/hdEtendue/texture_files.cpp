#include "texture_files.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <mutex>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include <pxr/usd/ar/asset.h>
#include <pxr/usd/ar/packageUtils.h>
#include <pxr/usd/ar/resolvedPath.h>
#include <pxr/usd/ar/resolver.h>
#include <pxr/usd/sdf/assetPath.h>

namespace etendue::hydra {
namespace {

constexpr std::string_view kUdim = "<UDIM>";

bool is_file(const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
}

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
            std::error_code none;
            std::string name = (std::filesystem::temp_directory_path(none) / "etendue-XXXXXX").string();
            if (none || ::mkdtemp(name.data()) == nullptr) return {};
            directory_ = name;
        }
        const std::string inner = ArSplitPackageRelativePathInner(resolved).second;
        const std::filesystem::path file = directory_ / (std::to_string(std::hash<std::string>()(resolved)) + "-" +
                                                         std::filesystem::path(inner).filename().string());
        if (!is_file(file) && !copy(resolved, file)) return {};
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

/// A set of tiles is there when any of them is: what is missing shows the fallback.
bool is_there(const std::string& name) {
    const std::size_t mark = name.find(kUdim);
    if (mark == std::string::npos) return is_file(name);
    for (int tile = 1001; tile <= 1100; ++tile) {
        std::string file = name;
        if (is_file(file.replace(mark, kUdim.size(), std::to_string(tile)))) return true;
    }
    return false;
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
