#pragma once

#include <string>
#include <string_view>

namespace etendue {

/// UDIM tiles: 1001 + column + 10 row, ten columns; UsdUVTexture knows ten rows.
inline constexpr std::string_view kUdimToken = "<UDIM>";
inline constexpr int kUdimColumns = 10;
inline constexpr int kUdimTiles = 100;
inline constexpr int kFirstUdim = 1001;

[[nodiscard]] inline bool is_udim(const std::string& file) { return file.find(kUdimToken) != std::string::npos; }

/// The file of one tile, counted from 0.
[[nodiscard]] inline std::string udim_file(const std::string& file, int tile) {
    std::string result = file;
    return result.replace(result.find(kUdimToken), kUdimToken.size(), std::to_string(kFirstUdim + tile));
}

}  // namespace etendue
