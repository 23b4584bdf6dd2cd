#include "io/image_output.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <etendue/error.h>

#include "io/replaced_file.h"

namespace etendue {

namespace {

// Bounds the memory taken beside the image; the formats that compress strips take at most 16 rows for one.
constexpr int kRowsAtOnce = 64;

[[noreturn]] void fail(const std::string& file, const std::string& reason) {
    throw FileError("cannot write '" + file + "': " + reason);
}

void write_strips(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec, const std::string& file,
                  const FillRow& fill_row) {
    const std::size_t row_bytes = spec.scanline_bytes();
    std::vector<std::byte> strip(row_bytes * static_cast<std::size_t>(std::min(kRowsAtOnce, spec.height)));
    for (int begin = 0; begin < spec.height; begin += kRowsAtOnce) {
        const int end = std::min(begin + kRowsAtOnce, spec.height);
        for (int y = begin; y < end; ++y) fill_row(y, strip.data() + row_bytes * static_cast<std::size_t>(y - begin));
        if (!output.write_scanlines(spec.y + begin, spec.y + end, 0, spec.format, strip.data())) {
            fail(file, output.geterror());
        }
    }
}

}  // namespace

void write_rows(const std::string& file, const OIIO::ImageSpec& spec, const FillRow& fill_row) {
    ReplacedFile replaced(file);
    const auto output = OIIO::ImageOutput::create(file);
    if (!output) fail(file, OIIO::geterror());
    if (!output->open(replaced.temporary(), spec)) fail(file, output->geterror());
    write_strips(*output, spec, file, fill_row);
    if (!output->close()) fail(file, output->geterror());
    replaced.commit();
}

const float* checked_data(const std::string& file, const RenderedImage& image, const std::string& name, int channels,
                          const std::vector<float>& data) {
    const auto width = static_cast<std::size_t>(std::max(image.width, 0));
    const auto height = static_cast<std::size_t>(std::max(image.height, 0));
    const std::size_t expected = width * height * static_cast<std::size_t>(channels);
    if (expected == 0 || data.size() != expected) {
        throw Error("cannot write '" + file + "': " + name + " has " + std::to_string(data.size()) +
                    " values, for an image of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                    " in " + std::to_string(channels) + " channels");
    }
    return data.data();
}

const float* checked_data(const std::string& file, const RenderedImage& image, const AovImage& aov) {
    const std::string name(aov_name(aov.aov));
    if (aov.channels != aov_channels(aov.aov)) {
        throw Error("cannot write '" + file + "': " + name + " has " + std::to_string(aov.channels) + " channels");
    }
    return checked_data(file, image, name, aov.channels, aov.data);
}

}  // namespace etendue
