#include "accel/embree_accel.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <limits>
#include <string>
#include <utility>

#include <etendue/error.h>

namespace etendue {
namespace {

struct DeviceDeleter {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneDeleter {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using DeviceHandle = std::unique_ptr<std::remove_pointer_t<RTCDevice>, DeviceDeleter>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, SceneDeleter>;

void quadric_bounds(const RTCBoundsFunctionArguments* args) {
    const Quadric::Bounds b = static_cast<const Quadric*>(args->geometryUserPtr)->bounds();
    // Outwards by a float's rounding: the box must hold the exact surface.
    RTCBounds& out = *args->bounds_o;
    out.lower_x = static_cast<float>(detail::round_to_float(b.lower.x, -1));
    out.lower_y = static_cast<float>(detail::round_to_float(b.lower.y, -1));
    out.lower_z = static_cast<float>(detail::round_to_float(b.lower.z, -1));
    out.upper_x = static_cast<float>(detail::round_to_float(b.upper.x, 1));
    out.upper_y = static_cast<float>(detail::round_to_float(b.upper.y, 1));
    out.upper_z = static_cast<float>(detail::round_to_float(b.upper.z, 1));
}

std::optional<double> hit_quadric(const void* user, const RTCRay& ray) {
    return static_cast<const Quadric*>(user)->intersect(Vec3(ray.org_x, ray.org_y, ray.org_z),
                                                        Vec3(ray.dir_x, ray.dir_y, ray.dir_z), ray.tnear, ray.tfar);
}

// Only rtcIntersect1 and rtcOccluded1 are called, so N is 1 and the packets are plain rays.
void quadric_intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto* ray_hit = reinterpret_cast<RTCRayHit*>(args->rayhit);
    const auto t = hit_quadric(args->geometryUserPtr, ray_hit->ray);
    if (!t) return;
    ray_hit->ray.tfar = static_cast<float>(*t);
    ray_hit->hit.u = 0;
    ray_hit->hit.v = 0;
    ray_hit->hit.primID = args->primID;
    ray_hit->hit.geomID = args->geomID;
    ray_hit->hit.instID[0] = args->context->instID[0];
}

void quadric_occluded(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto* ray = reinterpret_cast<RTCRay*>(args->ray);
    if (hit_quadric(args->geometryUserPtr, *ray)) ray->tfar = -std::numeric_limits<float>::infinity();
}

RTCGeometry make_geometry(RTCDevice device, const TriangleMesh& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.points.data(), 0,
                               sizeof(Float3), mesh.point_count());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                               sizeof(TriangleIndices), mesh.triangles.size());
    return geometry;
}

RTCGeometry make_geometry(RTCDevice device, const Quadric& quadric) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcSetGeometryUserData(geometry, const_cast<Quadric*>(&quadric));  // NOLINT: Embree's pointer is not const
    rtcSetGeometryBoundsFunction(geometry, [](const RTCBoundsFunctionArguments* a) { quadric_bounds(a); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, quadric_intersect);
    rtcSetGeometryOccludedFunction(geometry, quadric_occluded);
    return geometry;
}

void attach(RTCScene scene, RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

SceneHandle new_scene(RTCDevice device, const std::vector<const PlacedGeometry*>& geometries) {
    SceneHandle scene(rtcNewScene(device));
    // Watertight at shared edges: a ray that slips between two triangles of the pool is a wrong caustic.
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    for (const PlacedGeometry* geometry : geometries) {
        attach(scene.get(), std::visit([&](const auto& g) { return make_geometry(device, g); }, *geometry));
    }
    return scene;
}

RTCRay to_embree(const Ray& ray, double t_max) {
    RTCRay out{};
    out.org_x = static_cast<float>(ray.origin.x);
    out.org_y = static_cast<float>(ray.origin.y);
    out.org_z = static_cast<float>(ray.origin.z);
    out.dir_x = static_cast<float>(ray.direction.x);
    out.dir_y = static_cast<float>(ray.direction.y);
    out.dir_z = static_cast<float>(ray.direction.z);
    out.tnear = 0;
    out.tfar = static_cast<float>(t_max);
    out.mask = 0xffffffff;
    return out;
}

}  // namespace

class EmbreeAccel::Impl {
public:
    explicit Impl(const AccelInput& input) : device_(rtcNewDevice(nullptr)), top_count_(input.top.size()) {
        check();
        check_version();
        rtcSetDeviceErrorFunction(device_.get(), &Impl::on_error, this);
        rtcSetDeviceMemoryMonitorFunction(device_.get(), &Impl::on_memory, this);
        for (const auto& group : input.groups) {
            groups_.push_back(new_scene(device_.get(), group));
            rtcCommitScene(groups_.back().get());
        }
        scene_ = new_scene(device_.get(), input.top);
        for (const AccelInput::Instance& instance : input.instances) attach_instance(instance);
        rtcCommitScene(scene_.get());
        check();
        if (!message_.empty()) throw Error("Embree: " + message_);
        rtcSetDeviceErrorFunction(device_.get(), nullptr, nullptr);
    }

    [[nodiscard]] RTCScene scene() const { return scene_.get(); }
    [[nodiscard]] std::int64_t memory_used() const { return memory_used_; }

    [[nodiscard]] AccelHit to_hit(const RTCRayHit& rh) const {
        AccelHit hit;
        hit.t = rh.ray.tfar;
        hit.primitive = rh.hit.primID;
        hit.geometry = rh.hit.geomID;
        if (rh.hit.instID[0] != RTC_INVALID_GEOMETRY_ID) {
            hit.instance = rh.hit.instID[0] - static_cast<std::uint32_t>(top_count_);
        }
        hit.u = rh.hit.u;
        hit.v = rh.hit.v;
        return hit;
    }

private:
    void attach_instance(const AccelInput::Instance& instance) {
        RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(geometry, groups_[instance.group].get());
        const std::array<float, 12> matrix = instance.world_from_group.to_float3x4();
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix.data());
        attach(scene_.get(), geometry);
    }

    void check() const {
        if (!device_) throw Error("Embree: no device");
        const RTCError code = rtcGetDeviceError(device_.get());
        if (code != RTC_ERROR_NONE) throw Error("Embree: error " + std::to_string(code) + " " + message_);
    }

    /// Embree's symbols carry no version: in a process that has loaded another one for all to see (Blender has Embree
    /// 4), our calls end there, and rays hit nothing without a word.
    void check_version() const {
        const auto major = rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_VERSION_MAJOR);
        if (major == RTC_VERSION_MAJOR) return;
        throw Error("Embree: made for version " + std::to_string(RTC_VERSION_MAJOR) + ", but the process has loaded " +
                    std::to_string(major) + " in its place");
    }

    static void on_error(void* self, RTCError code, const char* text) {
        static_cast<Impl*>(self)->message_ = "error " + std::to_string(code) + ": " + (text != nullptr ? text : "");
    }

    /// From any of the threads that build.
    static bool on_memory(void* self, ssize_t bytes, bool /*after*/) {
        static_cast<Impl*>(self)->memory_used_ += bytes;
        return true;
    }

    std::atomic<std::int64_t> memory_used_{0};  ///< goes after the device, which counts to its end
    DeviceHandle device_;
    std::vector<SceneHandle> groups_;
    SceneHandle scene_;
    std::size_t top_count_;
    std::string message_;
};

EmbreeAccel::EmbreeAccel(const AccelInput& input) : impl_(std::make_unique<Impl>(input)) {}
EmbreeAccel::~EmbreeAccel() = default;
EmbreeAccel::EmbreeAccel(EmbreeAccel&&) noexcept = default;
EmbreeAccel& EmbreeAccel::operator=(EmbreeAccel&&) noexcept = default;

std::optional<AccelHit> EmbreeAccel::intersect(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit rh{};
    rh.ray = to_embree(ray, kInfinity);
    rh.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rh.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(impl_->scene(), &context, &rh);
    if (rh.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return impl_->to_hit(rh);
}

bool EmbreeAccel::occluded(const Ray& ray, double t_max) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay r = to_embree(ray, t_max);
    rtcOccluded1(impl_->scene(), &context, &r);
    return r.tfar < 0;
}

std::optional<AccelBounds> EmbreeAccel::bounds() const {
    RTCBounds b;
    rtcGetSceneBounds(impl_->scene(), &b);
    if (!(b.lower_x <= b.upper_x)) return {};
    return AccelBounds{{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
}

std::int64_t EmbreeAccel::memory_used() const { return impl_->memory_used(); }

}  // namespace etendue
