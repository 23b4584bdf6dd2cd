#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include <pxr/imaging/hd/renderBuffer.h>

#include "usd.h"

namespace etendue::hydra {

/// Pixels in the host's memory, row 0 at the bottom. Only the host's own thread writes them, while it executes a render
/// pass, so whatever it maps stands still.
class RenderBuffer final : public HdRenderBuffer {
public:
    explicit RenderBuffer(const SdfPath& path) : HdRenderBuffer(path) {}

    bool Allocate(const GfVec3i& dimensions, HdFormat format, bool multi_sampled) override;
    [[nodiscard]] unsigned int GetWidth() const override { return width_; }
    [[nodiscard]] unsigned int GetHeight() const override { return height_; }
    [[nodiscard]] unsigned int GetDepth() const override { return 1; }
    [[nodiscard]] HdFormat GetFormat() const override { return format_; }
    [[nodiscard]] bool IsMultiSampled() const override { return false; }
    void* Map() override;
    void Unmap() override { --mappers_; }
    [[nodiscard]] bool IsMapped() const override { return mappers_ > 0; }
    void Resolve() override {}
    [[nodiscard]] bool IsConverged() const override { return converged_; }

    void set_converged(bool converged) { converged_ = converged; }
    /// Sets all pixels; components that the value has not are 0, an empty value changes nothing.
    void clear(const VtValue& value);
    /// Sets the pixel `x` from the left and `y` from the top; components beyond `count` are 0, excess ones dropped.
    /// Outside the buffer nothing happens.
    void write(int x, int y, const double* components, std::size_t count);

    /// Its number among those of all buffers: pixels written before it are lost.
    [[nodiscard]] std::uint64_t allocation() const { return allocation_; }

private:
    void _Deallocate() override;

    unsigned int width_ = 0;
    unsigned int height_ = 0;
    HdFormat format_ = HdFormatInvalid;
    std::vector<std::uint8_t> data_;
    std::uint64_t allocation_ = 0;
    std::atomic<int> mappers_{0};
    std::atomic<bool> converged_{false};
};

}  // namespace etendue::hydra
