#include "render_buffer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <pxr/base/gf/half.h>
#include <pxr/base/gf/vec3i.h>
#include <pxr/base/tf/diagnostic.h>

#include "convert.h"

namespace etendue::hydra {
namespace {

/// Rounded to the nearest code, clamped to the type's range; `one` is the code of 1.
template <class Code>
Code quantised(double value, double one) {
    constexpr double lowest = std::numeric_limits<Code>::lowest();
    constexpr double highest = std::numeric_limits<Code>::max();
    if (std::isnan(value)) return 0;
    return static_cast<Code>(std::clamp(std::round(value * one), lowest, highest));
}

template <class Code>
void put(std::uint8_t* to, Code code) {
    std::memcpy(to, &code, sizeof code);
}

void put_component(std::uint8_t* to, HdFormat component, double value) {
    switch (component) {
        case HdFormatUNorm8:
            return put(to, quantised<std::uint8_t>(value, 255));
        case HdFormatSNorm8:
            return put(to, quantised<std::int8_t>(value, 127));
        case HdFormatFloat16:
            return put(to, GfHalf(static_cast<float>(value)).bits());
        case HdFormatFloat32:
            return put(to, static_cast<float>(value));
        case HdFormatInt16:
            return put(to, quantised<std::int16_t>(value, 1));
        case HdFormatUInt16:
            return put(to, quantised<std::uint16_t>(value, 1));
        case HdFormatInt32:
            return put(to, quantised<std::int32_t>(value, 1));
        default:
            return;
    }
}

/// Depth with a stencil of eight bits in a word of its own, for which HdGetComponentFormat knows no component.
bool is_depth_stencil(HdFormat format) { return format == HdFormatFloat32UInt8; }

}  // namespace

bool RenderBuffer::Allocate(const GfVec3i& dimensions, HdFormat format, bool /*multi_sampled*/) {
    _Deallocate();
    if (dimensions[0] < 0 || dimensions[1] < 0 || dimensions[2] != 1 || format == HdFormatInvalid) {
        TF_WARN("Etendue: <%s>: a render buffer of %d x %d x %d pixels cannot be made", GetId().GetText(),
                dimensions[0], dimensions[1], dimensions[2]);
        return false;
    }
    width_ = static_cast<unsigned int>(dimensions[0]);
    height_ = static_cast<unsigned int>(dimensions[1]);
    format_ = format;
    data_.assign(std::size_t{width_} * height_ * HdDataSizeOfFormat(format), 0);
    static std::atomic<std::uint64_t> allocations{0};
    allocation_ = ++allocations;
    return true;
}

void RenderBuffer::_Deallocate() {
    width_ = 0;
    height_ = 0;
    format_ = HdFormatInvalid;
    data_.clear();
    data_.shrink_to_fit();
    converged_ = false;
}

void* RenderBuffer::Map() {
    ++mappers_;
    return data_.data();
}

void RenderBuffer::clear(const VtValue& value) {
    const std::vector<double> components = numbers(value);
    if (components.empty()) return;
    for (unsigned int y = 0; y < height_; ++y) {
        for (unsigned int x = 0; x < width_; ++x) {
            write(static_cast<int>(x), static_cast<int>(y), components.data(), components.size());
        }
    }
}

void RenderBuffer::write(int x, int y, const double* components, std::size_t count) {
    if (x < 0 || y < 0 || x >= static_cast<int>(width_) || y >= static_cast<int>(height_)) return;
    const auto row = height_ - 1 - static_cast<unsigned int>(y);
    const std::size_t pixel = std::size_t{row} * width_ + static_cast<unsigned int>(x);
    std::uint8_t* to = data_.data() + pixel * HdDataSizeOfFormat(format_);
    if (is_depth_stencil(format_)) return put(to, count > 0 ? static_cast<float>(components[0]) : 0.0F);
    const HdFormat component = HdGetComponentFormat(format_);
    const std::size_t size = HdDataSizeOfFormat(component);
    for (std::size_t i = 0; i < HdGetComponentCount(format_); ++i) {
        put_component(to + i * size, component, i < count ? components[i] : 0.0);
    }
}

}  // namespace etendue::hydra
