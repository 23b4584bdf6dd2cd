#include "texture/texture_set.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include <etendue/error.h>

#include "texture/texture_cache.h"
#include "texture/udim.h"
#include "texture/wrap.h"

namespace etendue {

namespace {

/// A TextureDesc with its files open and every choice made.
struct Texture {
    std::array<double, 6> st_transform;
    std::array<double, 4> scale;
    std::array<double, 4> bias;
    std::array<double, 4> fallback;
    TextureWrap wrap_s;
    TextureWrap wrap_t;
    TextureColorSpace color_space;
    bool udim;
    std::vector<const CachedImage*> images;  ///< one, or kUdimTiles of which some are null
};

TextureWrap resolve_wrap(TextureWrap authored, TextureWrap from_metadata) {
    return authored == TextureWrap::UseMetadata ? from_metadata : authored;
}

std::vector<const CachedImage*> open_udim(const TextureDesc& desc, TextureCache& cache) {
    std::vector<const CachedImage*> images(kUdimTiles, nullptr);
    bool any = false;
    for (int tile = 0; tile < kUdimTiles; ++tile) {
        const std::string file = udim_file(desc.file, tile);
        std::error_code error;
        if (!std::filesystem::exists(file, error)) continue;
        images[static_cast<std::size_t>(tile)] = cache.open(desc.name, file);
        any = true;
    }
    if (!any) throw FileError("texture " + desc.name + ": no tile of '" + desc.file + "' exists");
    return images;
}

Texture open_texture(const TextureDesc& desc, TextureCache& cache) {
    const bool udim = is_udim(desc.file);
    Texture texture{desc.st_transform, desc.scale, desc.bias, desc.fallback, TextureWrap::Clamp, TextureWrap::Clamp,
                    desc.color_space,  udim,       {}};
    if (udim) {
        texture.images = open_udim(desc, cache);
        return texture;
    }
    const CachedImage* image = cache.open(desc.name, desc.file);
    texture.wrap_s = resolve_wrap(desc.wrap_s, image->wrap_s);
    texture.wrap_t = resolve_wrap(desc.wrap_t, image->wrap_t);
    texture.images = {image};
    return texture;
}

/// Two neighbouring texels along one axis and how much of the second to take.
struct Neighbours {
    int first;
    int second;
    double weight;
};

/// u is in units of the image's size, from the side where index 0 is. Texel i covers [i, i + 1) / n.
Neighbours neighbours(TextureWrap wrap, double u, int n) {
    const double x = reduce_coordinate(wrap, u) * n - 0.5;
    const double below = std::floor(x);
    const int first = static_cast<int>(below);
    return {wrap_index(wrap, first, n), wrap_index(wrap, first + 1, n), x - below};
}

std::optional<Texel> texel_or_black(TextureCache::Reader& reader, const CachedImage& image, int x, int y, bool srgb) {
    if (x == kOutside || y == kOutside) return Texel{};
    return reader.texel(image, x, y, srgb);
}

/// The mean of four texels, weighted by nearness; none when one cannot be read.
std::optional<Texel> bilinear(TextureCache::Reader& reader, const CachedImage& image, const Neighbours& x,
                              const Neighbours& y, bool srgb) {
    Texel sum{};
    for (int corner = 0; corner < 4; ++corner) {
        const bool right = (corner & 1) != 0;
        const bool lower = (corner & 2) != 0;
        const double weight = (right ? x.weight : 1 - x.weight) * (lower ? y.weight : 1 - y.weight);
        if (weight == 0) continue;
        const auto texel = texel_or_black(reader, image, right ? x.second : x.first, lower ? y.second : y.first, srgb);
        if (!texel) return std::nullopt;
        for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * (*texel)[c];
    }
    return sum;
}

bool decodes_srgb(const Texture& texture, const CachedImage& image) {
    return texture.color_space == TextureColorSpace::Srgb ||
           (texture.color_space == TextureColorSpace::Auto && image.auto_srgb);
}

/// The image that has st, and st within it; null where there is none.
const CachedImage* select_image(const Texture& texture, double& s, double& t) {
    if (!texture.udim) return texture.images.front();
    const double column = std::floor(s);
    const double row = std::floor(t);
    constexpr int kUdimRows = kUdimTiles / kUdimColumns;
    if (column < 0 || column >= kUdimColumns || row < 0 || row >= kUdimRows) return nullptr;
    s -= column;
    t -= row;
    return texture.images[static_cast<std::size_t>(column) + kUdimColumns * static_cast<std::size_t>(row)];
}

}  // namespace

class TextureSet::Impl {
public:
    Impl(std::span<const TextureDesc> descriptions, double memory_megabytes, const std::vector<bool>& unused)
        : cache(memory_megabytes), textures(descriptions.size()) {
        for (std::size_t i = 0; i < textures.size(); ++i) {
            if (unused.empty() || !unused[i]) textures[i] = open_texture(descriptions[i], cache);
        }
    }

    [[nodiscard]] Value lookup(const Texture& texture, double s, double t);
    [[nodiscard]] Value texel(const Texture& texture, int x, int y);
    /// Of what was read, which may have failed.
    [[nodiscard]] Value value(const Texture& texture, const std::optional<Texel>& texel);

    TextureCache cache;
    std::vector<Texture> textures;
    std::atomic<std::uint64_t> failed_lookups{0};
};

TextureSet::Value TextureSet::Impl::lookup(const Texture& texture, double s, double t) {
    const auto& m = texture.st_transform;
    double u = m[0] * s + m[1] * t + m[2];
    double v = m[3] * s + m[4] * t + m[5];
    if (!std::isfinite(u) || !std::isfinite(v)) return texture.fallback;
    const CachedImage* image = select_image(texture, u, v);
    if (!image) return texture.fallback;
    const Neighbours x = neighbours(texture.wrap_s, u, image->width);
    const Neighbours y = neighbours(texture.wrap_t, 1 - v, image->height);  // rows run down, t runs up
    return value(texture, bilinear(cache.reader(), *image, x, y, decodes_srgb(texture, *image)));
}

TextureSet::Value TextureSet::Impl::texel(const Texture& texture, int x, int y) {
    const CachedImage& image = *texture.images.front();
    return value(texture, cache.reader().texel(image, x, y, decodes_srgb(texture, image)));
}

TextureSet::Value TextureSet::Impl::value(const Texture& texture, const std::optional<Texel>& texel) {
    if (!texel) {
        ++failed_lookups;
        cache.forget_error();
        return texture.fallback;
    }
    Value value;
    for (std::size_t c = 0; c < 4; ++c) value[c] = (*texel)[c] * texture.scale[c] + texture.bias[c];
    return value;
}

TextureSet::TextureSet(std::span<const TextureDesc> textures, double memory_megabytes, const std::vector<bool>& unused)
    : impl_(std::make_unique<Impl>(textures, memory_megabytes, unused)) {}
TextureSet::~TextureSet() = default;
TextureSet::TextureSet(TextureSet&&) noexcept = default;
TextureSet& TextureSet::operator=(TextureSet&&) noexcept = default;

std::size_t TextureSet::size() const { return impl_->textures.size(); }

TextureSet::Resolution TextureSet::resolution(int texture) const {
    const auto& images = impl_->textures[static_cast<std::size_t>(texture)].images;
    const CachedImage& image = **std::find_if(images.begin(), images.end(), [](const auto* i) { return i != nullptr; });
    return {image.width, image.height};
}

TextureSet::Value TextureSet::lookup(int texture, double s, double t) const {
    return impl_->lookup(impl_->textures[static_cast<std::size_t>(texture)], s, t);
}

TextureSet::Value TextureSet::texel(int texture, int x, int y) const {
    return impl_->texel(impl_->textures[static_cast<std::size_t>(texture)], x, y);
}

double TextureSet::lookup_channel(int texture, double s, double t, int channel) const {
    return lookup(texture, s, t)[static_cast<std::size_t>(channel)];
}

std::size_t TextureSet::file_count() const { return impl_->cache.file_count(); }

std::int64_t TextureSet::memory_used() const { return impl_->cache.memory_used(); }

std::uint64_t TextureSet::failed_lookups() const { return impl_->failed_lookups; }

}  // namespace etendue
