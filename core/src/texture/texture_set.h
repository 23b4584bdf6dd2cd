#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <etendue/render_settings.h>
#include <etendue/scene_description.h>

namespace etendue {

/// The scene's textures, read through one tile cache of their own: any number of sets may live in a process.
///
/// A value is what UsdUVTexture defines: texel * scale + bias, where texels are the file's numbers (0..1 for integer
/// formats), rgb decoded from sRGB where the colour space says so, alpha never decoded and never multiplied into rgb.
/// One channel v gives (v, v, v, 1), two (v, v, v, a), three (r, g, b, 1). The filter is bilinear on decoded texels of
/// the full resolution. st = (0, 0) is the lower left corner of the image.
///
/// Wrap UseMetadata takes the file's "wrapmodes", else Black. Black is 0 in all four channels before scale and bias,
/// and is filtered with: at s = 0 and s = 1 a value is half the border texel. A <UDIM> name stands for the tiles 1001
/// to 1100 that exist; each clamps at its edges, and where none is the value is the fallback.
class TextureSet {
public:
    using Value = std::array<double, 4>;

    /// Opens every file and decodes the end of it, so that what cannot be read is known here: throws FileError naming
    /// the prim, the file and the reason. (The readers of jpeg and tiff fill in what a file cut short lacks.) Files
    /// without tiles (png, jpeg, ...) count as one tile, which stays in the cache until the limit needs the room; each
    /// thread may hold up to TextureCache::kHeldTiles tiles beyond it. `unused`, by texture, marks those that nobody
    /// will look up: they are not opened.
    explicit TextureSet(std::span<const TextureDesc> textures, double memory_megabytes = kDefaultTextureMemory,
                        const std::vector<bool>& unused = {});
    ~TextureSet();
    TextureSet(TextureSet&&) noexcept;
    TextureSet& operator=(TextureSet&&) noexcept;

    [[nodiscard]] std::size_t size() const;

    struct Resolution {
        int width;
        int height;
    };
    /// Texels of the image (of a UDIM set's first tile).
    [[nodiscard]] Resolution resolution(int texture) const;

    /// The value of `textures[texture]` at st, before its st_transform. From any thread. The fallback when st is not
    /// finite or the file became unreadable after construction.
    [[nodiscard]] Value lookup(int texture, double s, double t) const;

    /// The value of one texel, columns from the left and rows from the top, of an image that is no UDIM set. The
    /// fallback when the file became unreadable.
    [[nodiscard]] Value texel(int texture, int x, int y) const;

    /// One channel, 0..3 = r, g, b, a.
    [[nodiscard]] double lookup_channel(int texture, double s, double t, int channel) const;

    [[nodiscard]] std::size_t file_count() const;        ///< distinct files, UDIM tiles singly
    [[nodiscard]] std::int64_t memory_used() const;      ///< bytes of texels in the cache
    [[nodiscard]] std::uint64_t failed_lookups() const;  ///< that met an unreadable tile

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace etendue
