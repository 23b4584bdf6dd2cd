#include "texture/texture_set.h"

#include <etendue/error.h>

namespace etendue {

/// No textures, and no image library.
class TextureSet::Impl {};

TextureSet::TextureSet(std::span<const TextureDesc> textures, double, const std::vector<bool>&) {
    if (!textures.empty()) throw FileError("textures are compiled out");
}
TextureSet::~TextureSet() = default;
TextureSet::TextureSet(TextureSet&&) noexcept = default;
TextureSet& TextureSet::operator=(TextureSet&&) noexcept = default;

std::size_t TextureSet::size() const { return 0; }
TextureSet::Resolution TextureSet::resolution(int) const { return {1, 1}; }
TextureSet::Value TextureSet::lookup(int, double, double) const { return {}; }
TextureSet::Value TextureSet::texel(int, int, int) const { return {}; }
double TextureSet::lookup_channel(int, double, double, int) const { return 0; }
std::size_t TextureSet::file_count() const { return 0; }
std::int64_t TextureSet::memory_used() const { return 0; }
std::uint64_t TextureSet::failed_lookups() const { return 0; }

}  // namespace etendue
