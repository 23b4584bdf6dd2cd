#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "geometry/quadric.h"
#include "geometry/ray.h"
#include "geometry/triangle_mesh.h"
#include "math/transform.h"

namespace etendue {

using PlacedGeometry = std::variant<TriangleMesh, Quadric>;

/// What to trace: geometry in world space, and groups of geometry placed by instances (two levels). The caller keeps
/// everything alive and in place as long as the accelerator.
struct AccelInput {
    struct Instance {
        std::size_t group;
        Transform world_from_group;

        [[nodiscard]] bool operator==(const Instance&) const = default;
    };
    std::vector<const PlacedGeometry*> top;
    std::vector<std::vector<const PlacedGeometry*>> groups;
    std::vector<Instance> instances;

    /// The same geometry, by address, in the same places.
    [[nodiscard]] bool operator==(const AccelInput&) const = default;
};

inline constexpr std::uint32_t kNoInstance = 0xffffffff;

struct AccelHit {
    double t = 0;
    std::uint32_t instance = kNoInstance;  ///< index into AccelInput::instances
    std::uint32_t geometry = 0;            ///< index into AccelInput::top, or into the instance's group
    std::uint32_t primitive = 0;
    double u = 0;  ///< barycentric weights of a triangle's second and third corner
    double v = 0;
};

struct AccelBounds {
    Vec3 lower;
    Vec3 upper;
};

/// Embree, hidden.
class EmbreeAccel {
public:
    /// Throws Error when Embree cannot build.
    explicit EmbreeAccel(const AccelInput& input);
    ~EmbreeAccel();
    EmbreeAccel(EmbreeAccel&&) noexcept;
    EmbreeAccel& operator=(EmbreeAccel&&) noexcept;

    /// Nearest hit at t > 0.
    [[nodiscard]] std::optional<AccelHit> intersect(const Ray& ray) const;
    /// Whether anything lies at 0 < t < t_max.
    [[nodiscard]] bool occluded(const Ray& ray, double t_max) const;
    /// Empty when nothing is there.
    [[nodiscard]] std::optional<AccelBounds> bounds() const;
    /// Bytes that Embree holds, as it counts them; while it builds it takes more.
    [[nodiscard]] std::int64_t memory_used() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace etendue
