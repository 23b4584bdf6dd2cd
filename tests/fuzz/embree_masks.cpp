// Embree computes with infinities and NaN on purpose: the reciprocal of a direction along an axis, empty boxes, lanes
// that hold nothing, inverses of matrices that its caller has yet to look at. The linker leads the core's calls of it
// through here (-Wl,--wrap), where the traps are off while Embree works and on again while it calls back into the
// core's own spheres.

#include <embree3/rtcore.h>

#include <atomic>
#include <cfenv>

#include "fuzz/traps.h"

// The names are the linker's.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" {
decltype(rtcIntersect1) __real_rtcIntersect1, __wrap_rtcIntersect1;
decltype(rtcOccluded1) __real_rtcOccluded1, __wrap_rtcOccluded1;
decltype(rtcCommitGeometry) __real_rtcCommitGeometry, __wrap_rtcCommitGeometry;
decltype(rtcCommitScene) __real_rtcCommitScene, __wrap_rtcCommitScene;
decltype(rtcNewDevice) __real_rtcNewDevice, __wrap_rtcNewDevice;
decltype(rtcSetGeometryIntersectFunction) __real_rtcSetGeometryIntersectFunction,
    __wrap_rtcSetGeometryIntersectFunction;
decltype(rtcSetGeometryOccludedFunction) __real_rtcSetGeometryOccludedFunction, __wrap_rtcSetGeometryOccludedFunction;
}

namespace etendue::test {
namespace {

/// Whether this thread's traps were on when it called Embree.
thread_local bool t_trapped = false;

class Masked {
public:
    Masked() : traps_((t_trapped = (fegetexcept() & FE_INVALID) != 0, false)) {}

private:
    InvalidTraps traps_;
};

// The core has one function of each kind.
std::atomic<RTCIntersectFunctionN> g_intersect{nullptr};
std::atomic<RTCOccludedFunctionN> g_occluded{nullptr};

void intersect(const RTCIntersectFunctionNArguments* args) {
    const InvalidTraps traps(t_trapped);
    g_intersect.load()(args);
}

void occluded(const RTCOccludedFunctionNArguments* args) {
    const InvalidTraps traps(t_trapped);
    g_occluded.load()(args);
}

}  // namespace
}  // namespace etendue::test

using etendue::test::Masked;

extern "C" {

void __wrap_rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray_hit) {
    const Masked masked;
    __real_rtcIntersect1(scene, context, ray_hit);
}

void __wrap_rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
    const Masked masked;
    __real_rtcOccluded1(scene, context, ray);
}

void __wrap_rtcCommitGeometry(RTCGeometry geometry) {
    const Masked masked;
    __real_rtcCommitGeometry(geometry);
}

void __wrap_rtcCommitScene(RTCScene scene) {
    const Masked masked;
    __real_rtcCommitScene(scene);
}

RTCDevice __wrap_rtcNewDevice(const char* config) {
    const Masked masked;
    return __real_rtcNewDevice(config);
}

void __wrap_rtcSetGeometryIntersectFunction(RTCGeometry geometry, RTCIntersectFunctionN intersect) {
    etendue::test::g_intersect = intersect;
    __real_rtcSetGeometryIntersectFunction(geometry, etendue::test::intersect);
}

void __wrap_rtcSetGeometryOccludedFunction(RTCGeometry geometry, RTCOccludedFunctionN occluded) {
    etendue::test::g_occluded = occluded;
    __real_rtcSetGeometryOccludedFunction(geometry, etendue::test::occluded);
}

}  // extern "C"
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
