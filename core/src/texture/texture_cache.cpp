#include "texture/texture_cache.h"

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <thread>
#include <unordered_map>

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/texture.h>

#include <etendue/error.h>

#include "texture/color_metadata.h"
#include "texture/half_float.h"
#include "texture/srgb.h"

namespace etendue {

namespace {

OIIO::ImageCache& as_cache(void* cache) { return *static_cast<OIIO::ImageCache*>(cache); }

using Perthread = OIIO::ImageCache::Perthread;
using ImageHandle = OIIO::ImageCache::ImageHandle;
using CacheTile = OIIO::ImageCache::Tile;

/// Half floats and 16-bit codes are the same bits with different meanings.
struct HalfBits {
    std::uint16_t bits;
};

constexpr int kByteCodes = 256;
using ByteTable = std::array<double, kByteCodes>;

ByteTable make_byte_table(double (*decode)(double)) {
    ByteTable table{};
    for (int code = 0; code < kByteCodes; ++code) table[static_cast<std::size_t>(code)] = decode(code / 255.0);
    return table;
}

double identity(double value) { return value; }

/// Byte codes are the usual case, and a power for each channel of each texel would be most of a lookup's time.
const ByteTable kRawBytes = make_byte_table(identity);
const ByteTable kSrgbBytes = make_byte_table(srgb_to_linear);

double channel_value(const std::uint8_t* pixel, int channel, bool srgb) {
    return (srgb ? kSrgbBytes : kRawBytes)[pixel[channel]];
}

double channel_value(const std::uint16_t* pixel, int channel, bool srgb) {
    const double value = pixel[channel] / 65535.0;
    return srgb ? srgb_to_linear(value) : value;
}

double channel_value(const HalfBits* pixel, int channel, bool srgb) {
    const double value = half_to_float(pixel[channel].bits);
    return srgb ? srgb_to_linear(value) : value;
}

double channel_value(const float* pixel, int channel, bool srgb) {
    const double value = pixel[channel];
    return srgb ? srgb_to_linear(value) : value;
}

template <typename T>
Texel decode(const CachedImage& image, const void* pixels, std::size_t index, bool srgb) {
    const T* pixel = static_cast<const T*>(pixels) + index * static_cast<std::size_t>(image.channels);
    const double r = channel_value(pixel, 0, srgb);
    const double a = image.alpha_channel < 0 ? 1.0 : channel_value(pixel, image.alpha_channel, false);
    if (image.channels < 3) return {r, r, r, a};
    return {r, channel_value(pixel, 1, srgb), channel_value(pixel, 2, srgb), a};
}

[[noreturn]] void fail(const std::string& prim, const std::string& file, const std::string& reason) {
    throw FileError("texture " + prim + ": cannot read '" + file + "': " + reason);
}

void check_exists(const std::string& prim, const std::string& file) {
    if (file.empty()) fail(prim, file, "no file is named");
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (std::filesystem::is_directory(status)) fail(prim, file, "it is a directory");
    if (status.type() == std::filesystem::file_type::not_found) fail(prim, file, "it does not exist");
    if (!std::filesystem::exists(status)) fail(prim, file, error.message());
}

TexelType texel_type(const OIIO::ImageSpec& spec) {
    switch (spec.format.basetype) {
        case OIIO::TypeDesc::UINT8:
            return TexelType::UInt8;
        case OIIO::TypeDesc::UINT16:
            return TexelType::UInt16;
        case OIIO::TypeDesc::HALF:
            return TexelType::Half;
        default:
            return TexelType::Float;  // the cache converts every other type
    }
}

TextureWrap wrap_from_metadata(OIIO::Tex::Wrap wrap) {
    switch (wrap) {
        case OIIO::Tex::Wrap::Clamp:
            return TextureWrap::Clamp;
        case OIIO::Tex::Wrap::Periodic:
            return TextureWrap::Repeat;
        case OIIO::Tex::Wrap::Mirror:
            return TextureWrap::Mirror;
        default:
            return TextureWrap::Black;
    }
}

void read_wrap_modes(const OIIO::ImageSpec& spec, CachedImage& image) {
    const std::string modes(spec.get_string_attribute("wrapmodes"));
    if (modes.empty()) return;
    OIIO::Tex::Wrap s = OIIO::Tex::Wrap::Default;
    OIIO::Tex::Wrap t = OIIO::Tex::Wrap::Default;
    OIIO::Tex::parse_wrapmodes(modes.c_str(), s, t);
    image.wrap_s = wrap_from_metadata(s);
    image.wrap_t = wrap_from_metadata(t);
}

/// Two and four channels end in alpha; with more, only a channel that says it is.
int find_alpha(const OIIO::ImageSpec& spec) {
    if (spec.nchannels == 2 || spec.nchannels == 4) return spec.nchannels - 1;
    return spec.nchannels > 4 ? spec.alpha_channel : -1;
}

CachedImage describe(const OIIO::ImageSpec& spec) {
    CachedImage image;
    image.width = spec.full_width;
    image.height = spec.full_height;
    image.data_x = spec.x - spec.full_x;
    image.data_y = spec.y - spec.full_y;
    image.origin_x = spec.x;
    image.origin_y = spec.y;
    image.data_width = spec.width;
    image.data_height = spec.height;
    image.tile_width = spec.tile_width;
    image.tile_height = spec.tile_height;
    image.channels = spec.nchannels;
    image.alpha_channel = find_alpha(spec);
    image.type = texel_type(spec);
    read_wrap_modes(spec, image);
    return image;
}

std::string file_format(OIIO::ImageCache& cache, ImageHandle* handle) {
    static const OIIO::ustring fileformat("fileformat");
    const char* format = nullptr;
    cache.get_image_info(handle, nullptr, 0, 0, fileformat, OIIO::TypeString, &format);
    return format ? format : "";
}

/// Tells caches apart for the threads; an address could be taken by a later cache.
std::uint64_t next_cache_id() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

}  // namespace

// ------------------------------------------------------------------------------------------------------ reader

TextureCache::Reader::Reader(void* cache) : cache_(cache), thread_info_(as_cache(cache).create_thread_info()) {}

TextureCache::Reader::~Reader() {
    for (const Tile& tile : tiles_) {
        if (tile.handle) as_cache(cache_).release_tile(static_cast<CacheTile*>(tile.handle));
    }
    as_cache(cache_).destroy_thread_info(static_cast<Perthread*>(thread_info_));
}

const void* TextureCache::Reader::load_tile(const CachedImage& image, int tile_x, int tile_y) {
    OIIO::ImageCache& cache = as_cache(cache_);
    auto* thread_info = cache.get_perthread_info(static_cast<Perthread*>(thread_info_));
    CacheTile* handle =
        cache.get_tile(static_cast<ImageHandle*>(image.handle), thread_info, 0, 0,
                       image.origin_x + tile_x * image.tile_width, image.origin_y + tile_y * image.tile_height, 0);
    OIIO::TypeDesc format;
    const void* pixels = handle ? cache.tile_pixels(handle, format) : nullptr;
    if (!pixels) {
        if (handle) cache.release_tile(handle);
        return nullptr;
    }
    Tile& slot = tiles_[oldest_];
    if (slot.handle) cache.release_tile(static_cast<CacheTile*>(slot.handle));
    slot = {handle, pixels, &image, tile_x, tile_y};
    latest_ = oldest_;
    oldest_ = (oldest_ + 1) % tiles_.size();
    return pixels;
}

const void* TextureCache::Reader::tile_pixels(const CachedImage& image, int tile_x, int tile_y) {
    const auto holds = [&](const Tile& tile) { return tile.image == &image && tile.x == tile_x && tile.y == tile_y; };
    if (holds(tiles_[latest_])) return tiles_[latest_].pixels;
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        if (!holds(tiles_[i])) continue;
        latest_ = i;
        return tiles_[i].pixels;
    }
    return load_tile(image, tile_x, tile_y);
}

std::optional<Texel> TextureCache::Reader::texel(const CachedImage& image, int x, int y, bool srgb) {
    const int column = x - image.data_x;
    const int row = y - image.data_y;
    if (column < 0 || row < 0 || column >= image.data_width || row >= image.data_height) return Texel{};
    const int tile_x = column / image.tile_width;
    const int tile_y = row / image.tile_height;
    const void* pixels = tile_pixels(image, tile_x, tile_y);
    if (!pixels) return std::nullopt;
    const auto index =
        static_cast<std::size_t>(row - tile_y * image.tile_height) * static_cast<std::size_t>(image.tile_width) +
        static_cast<std::size_t>(column - tile_x * image.tile_width);
    switch (image.type) {
        case TexelType::UInt8:
            return decode<std::uint8_t>(image, pixels, index, srgb);
        case TexelType::UInt16:
            return decode<std::uint16_t>(image, pixels, index, srgb);
        case TexelType::Half:
            return decode<HalfBits>(image, pixels, index, srgb);
        case TexelType::Float:
            break;
    }
    return decode<float>(image, pixels, index, srgb);
}

// ------------------------------------------------------------------------------------------------------- cache

class TextureCache::Impl {
public:
    explicit Impl(double memory_megabytes);

    [[nodiscard]] std::unique_ptr<CachedImage> read_header(const std::string& prim, const std::string& file) const;
    [[nodiscard]] std::string take_error() const;

    struct Destroy {
        void operator()(OIIO::ImageCache* cache) const { OIIO::ImageCache::destroy(cache); }
    };
    const std::uint64_t id = next_cache_id();
    std::unique_ptr<OIIO::ImageCache, Destroy> cache{OIIO::ImageCache::create(false)};
    std::unordered_map<std::string, std::unique_ptr<CachedImage>> images;
    std::mutex readers_mutex;
    std::unordered_map<std::thread::id, std::unique_ptr<Reader>> readers;  // goes before the cache it reads
};

TextureCache::Impl::Impl(double memory_megabytes) {
    cache->attribute("max_memory_MB", static_cast<float>(memory_megabytes));
    // UsdUVTexture means the file's numbers. OpenImageIO would multiply rgb by an unassociated alpha.
    cache->attribute("unassociatedalpha", 1);
    // Most untiled formats decode from the top: virtual tiles would mean decoding them again and again.
    cache->attribute("autotile", 0);
}

std::string TextureCache::Impl::take_error() const {
    std::string error = cache->geterror();
    while (!error.empty() && error.back() == '\n') error.pop_back();
    return error.empty() ? "it cannot be decoded" : error;
}

std::unique_ptr<CachedImage> TextureCache::Impl::read_header(const std::string& prim, const std::string& file) const {
    ImageHandle* handle = cache->get_image_handle(OIIO::ustring(file));
    OIIO::ImageSpec spec;  // as the cache holds it
    OIIO::ImageSpec native;
    if (!handle || !cache->get_imagespec(handle, nullptr, spec) ||
        !cache->get_imagespec(handle, nullptr, native, 0, 0, true)) {
        fail(prim, file, take_error());
    }
    auto image = std::make_unique<CachedImage>(describe(spec));
    image->handle = handle;
    image->auto_srgb = auto_color_space_is_srgb(file, file_format(*cache, handle), native);
    return image;
}

TextureCache::TextureCache(double memory_megabytes) : impl_(std::make_unique<Impl>(memory_megabytes)) {}
TextureCache::~TextureCache() = default;

TextureCache::Reader& TextureCache::reader() const {
    struct Latest {
        std::uint64_t cache_id = 0;
        Reader* reader = nullptr;
    };
    thread_local Latest latest;
    if (latest.cache_id == impl_->id) return *latest.reader;
    const std::lock_guard lock(impl_->readers_mutex);
    std::unique_ptr<Reader>& mine = impl_->readers[std::this_thread::get_id()];
    if (!mine) mine.reset(new Reader(impl_->cache.get()));
    latest = {impl_->id, mine.get()};
    return *mine;
}

const CachedImage* TextureCache::open(const std::string& prim, const std::string& file) {
    if (const auto found = impl_->images.find(file); found != impl_->images.end()) return found->second.get();
    check_exists(prim, file);
    std::unique_ptr<CachedImage> image = impl_->read_header(prim, file);
    const int last_x = image->data_x + image->data_width - 1;
    const int last_y = image->data_y + image->data_height - 1;
    if (!reader().texel(*image, last_x, last_y, false)) fail(prim, file, impl_->take_error());
    return impl_->images.emplace(file, std::move(image)).first->second.get();
}

void TextureCache::forget_error() const { (void)impl_->cache->geterror(); }

std::size_t TextureCache::file_count() const { return impl_->images.size(); }

std::int64_t TextureCache::memory_used() const {
    std::int64_t bytes = 0;
    impl_->cache->getattribute("stat:cache_memory_used", OIIO::TypeDesc::INT64, &bytes);
    return bytes;
}

}  // namespace etendue
