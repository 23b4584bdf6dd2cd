#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "math/rng.h"

namespace etendue::test {

/// What decides a random scene: a seed, or bytes that a fuzzer chose (zeros after their end).
class Dice {
public:
    explicit Dice(std::uint64_t seed) : rng_(seed, 0, 0) {}
    explicit Dice(std::span<const std::uint8_t> bytes) : rng_(0, 0, 0), bytes_(bytes), from_bytes_(true) {}

    /// In [0, 1), 32 bits.
    double unit();
    bool chance(double probability) { return unit() < probability; }
    /// 0 ... count - 1.
    int below(int count) { return static_cast<int>(unit() * count); }
    /// low ... high.
    int whole(int low, int high) { return low + below(high - low + 1); }
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// As often in each decade.
    double log_between(double low, double high);
    template <typename T>
    T one_of(std::initializer_list<T> values) {
        return values.begin()[below(static_cast<int>(values.size()))];
    }

    /// From now on number() gives, now and then, what is no number or far out of range.
    void turn_hostile() { hostile_ = true; }
    [[nodiscard]] bool hostile() const { return hostile_; }
    double number(double sensible);

    /// 0 to 1, often where formulas divide by nearly nothing; at times a bit outside.
    double fraction();
    /// `usual`, or at times one of 1e-20 ... 1e20.
    double power(double usual);

private:
    std::uint32_t next();

    Rng rng_;
    std::span<const std::uint8_t> bytes_;
    std::size_t used_ = 0;
    bool from_bytes_ = false;
    bool hostile_ = false;
};

}  // namespace etendue::test
