#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <etendue/scene_description.h>

namespace etendue {

enum class TexelType { UInt8, UInt16, Half, Float };

/// r, g, b, a.
using Texel = std::array<double, 4>;

/// One image file, with what a lookup needs of its header. Texel (0, 0) is the upper left corner of the image.
struct CachedImage {
    void* handle = nullptr;  ///< OpenImageIO's
    int width = 0;           ///< of the image (the display window)
    int height = 0;
    int data_x = 0;  ///< where the stored texels begin; where none are stored the image is black
    int data_y = 0;
    int origin_x = 0;  ///< the same in the file's own coordinates
    int origin_y = 0;
    int data_width = 0;
    int data_height = 0;
    int tile_width = 0;
    int tile_height = 0;
    int channels = 0;
    int alpha_channel = -1;  ///< none: alpha is 1
    TexelType type = TexelType::Float;
    bool auto_srgb = false;                   ///< what TextureColorSpace::Auto means for it
    TextureWrap wrap_s = TextureWrap::Black;  ///< what TextureWrap::UseMetadata means for it
    TextureWrap wrap_t = TextureWrap::Black;
};

/// Image files behind one tile cache. OpenImageIO is not visible beyond its .cpp.
class TextureCache {
public:
    /// Tiles that each thread keeps at hand; the cache cannot drop them.
    static constexpr int kHeldTiles = 8;

    explicit TextureCache(double memory_megabytes);
    ~TextureCache();
    TextureCache(const TextureCache&) = delete;
    TextureCache& operator=(const TextureCache&) = delete;

    /// The image; the same one for the same name. Decodes its last tile. Throws FileError naming `prim`, the file and
    /// the reason. Not to be called while other threads read.
    const CachedImage* open(const std::string& prim, const std::string& file);

    /// One thread's way to the texels.
    class Reader;
    /// The calling thread's. Valid for the cache's life, for this thread.
    [[nodiscard]] Reader& reader() const;

    /// Drops this thread's message about a texel that could not be read: OpenImageIO collects them without end.
    void forget_error() const;

    [[nodiscard]] std::size_t file_count() const;
    [[nodiscard]] std::int64_t memory_used() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

class TextureCache::Reader {
public:
    ~Reader();
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// The texel (black outside the image's data), rgb decoded from sRGB if asked; none when its tile cannot be read.
    [[nodiscard]] std::optional<Texel> texel(const CachedImage& image, int x, int y, bool srgb);

private:
    friend class TextureCache;
    struct Tile {
        void* handle = nullptr;
        const void* pixels = nullptr;
        const CachedImage* image = nullptr;
        int x = 0;  ///< in tiles
        int y = 0;
    };

    explicit Reader(void* cache);
    [[nodiscard]] const void* tile_pixels(const CachedImage& image, int tile_x, int tile_y);
    [[nodiscard]] const void* load_tile(const CachedImage& image, int tile_x, int tile_y);

    void* cache_;
    void* thread_info_;
    std::array<Tile, kHeldTiles> tiles_{};
    std::size_t latest_ = 0;
    std::size_t oldest_ = 0;
};

}  // namespace etendue
