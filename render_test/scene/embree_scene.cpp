#include "render_test/scene/embree_scene.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "render_test/sampling/sampler.h"
#include "render_test/scene/scene_checks.h"
#include "render_test/scene/scene_shape.h"

namespace lancret {
namespace {

// The calls in which Embree 3 and 4 differ.
#if RTC_VERSION_MAJOR >= 4
void first_hit(RTCScene scene, RTCRayHit* hit) { rtcIntersect1(scene, hit); }
void any_hit(RTCScene scene, RTCRay* ray) { rtcOccluded1(scene, ray); }
#else
void first_hit(RTCScene scene, RTCRayHit* hit) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, hit);
}
void any_hit(RTCScene scene, RTCRay* ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, ray);
}
#endif

RTCRay embree_ray(const Ray& ray) {
    RTCRay r{};
    r.org_x = ray.origin.x(), r.org_y = ray.origin.y(), r.org_z = ray.origin.z();
    r.dir_x = ray.direction.x(), r.dir_y = ray.direction.y(), r.dir_z = ray.direction.z();
    r.tnear = ray.near, r.tfar = ray.far;
    r.time = ray.time;
    r.mask = ~0u;
    r.id = ray.by_chance;
    return r;
}

RTCGeometryType geometry_type(const Curves& curves) {
    if (curves.shape == CurveShape::ribbon) {
        return RTC_GEOMETRY_TYPE_NORMAL_ORIENTED_BSPLINE_CURVE;
    }
    const bool flat = curves.shape == CurveShape::flat;
    if (curves.basis == CurveBasis::bspline) {
        return flat ? RTC_GEOMETRY_TYPE_FLAT_BSPLINE_CURVE
                    : RTC_GEOMETRY_TYPE_ROUND_BSPLINE_CURVE;
    }
    return flat ? RTC_GEOMETRY_TYPE_FLAT_HERMITE_CURVE
                : RTC_GEOMETRY_TYPE_ROUND_HERMITE_CURVE;
}

}  // namespace

struct HairScene::Impl {
    SceneShape shape;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    unsigned strands_id = RTC_INVALID_GEOMETRY_ID;
    std::atomic<std::ptrdiff_t> bytes = 0;
    double build_seconds = 0;

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void check(const char* doing) const {
        const RTCError error = rtcGetDeviceError(device);
        if (error == RTC_ERROR_NONE) return;
        throw std::runtime_error(std::string("Embree, ") + doing + ": " +
                                 (error == RTC_ERROR_OUT_OF_MEMORY
                                      ? "out of memory"
                                      : "error " + std::to_string(int(error))));
    }

    unsigned attach(RTCGeometry geometry, const char* doing) {
        rtcCommitGeometry(geometry);
        const unsigned id = rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        check(doing);
        return id;
    }

    void add_strands(int tessellation) {
        const Curves& first = *shape.curves[0];
        const RTCGeometry g = rtcNewGeometry(device, geometry_type(first));
        if (shape.times() > 1) rtcSetGeometryTimeStepCount(g, unsigned(shape.times()));
        const auto share = [&](RTCBufferType type, unsigned slot, const auto& buffer,
                               RTCFormat format = RTC_FORMAT_FLOAT4) {
            rtcSetSharedGeometryBuffer(g, type, slot, format, buffer.data(), 0,
                                       sizeof(Point4f), buffer.size());
        };
        for (unsigned t = 0; t < shape.times(); ++t) {
            share(RTC_BUFFER_TYPE_VERTEX, t, shape.curves[t]->points);
            if (first.basis == CurveBasis::hermite) {
                share(RTC_BUFFER_TYPE_TANGENT, t, shape.curves[t]->tangents);
            }
            if (first.shape == CurveShape::ribbon) {
                share(RTC_BUFFER_TYPE_NORMAL, t, shape.curves[t]->normals,
                      RTC_FORMAT_FLOAT3);
            }
        }
        rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                                   first.segments.data(), 0, sizeof(std::uint32_t),
                                   first.segments.size());
        if (!shape.true_radii.empty() || shape.aspect < 1) {
            rtcSetGeometryUserData(g, &shape);
            rtcSetGeometryIntersectFilterFunction(g, hit_counts);
            rtcSetGeometryOccludedFilterFunction(g, hit_counts);
        }
        if (first.shape == CurveShape::flat) {
            rtcSetGeometryTessellationRate(g, float(tessellation));
        }
        strands_id = attach(g, "adding strands");
    }

    /// Copies the mesh, because Embree reads 16 bytes at the last vertex.
    void add_mesh() {
        const RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        if (shape.times() > 1) rtcSetGeometryTimeStepCount(g, unsigned(shape.times()));
        for (unsigned t = 0; t < shape.times(); ++t) {
            const std::vector<Vec3f>& from = shape.vertices_at(t);
            void* positions =
                rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, t, RTC_FORMAT_FLOAT3,
                                        sizeof(Vec3f), from.size());
            if (positions) std::ranges::copy(from, static_cast<Vec3f*>(positions));
        }
        void* triangles = rtcSetNewGeometryBuffer(
            g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
            sizeof(std::array<std::uint32_t, 3>), shape.mesh.triangles.size());
        if (triangles) {
            std::ranges::copy(shape.mesh.triangles,
                              static_cast<std::array<std::uint32_t, 3>*>(triangles));
        }
        attach(g, "adding a mesh");
    }

    /// Embree's filter: rejects hits that do not count.
    static void hit_counts(const RTCFilterFunctionNArguments* args) {
        if (args->N != 1 || !args->valid[0]) return;
        const auto& scene = *static_cast<const SceneShape*>(args->geometryUserPtr);
        if (scene.aspect < 1 &&
            !scene.within_section(
                RTCHitN_primID(args->hit, 1, 0), RTCHitN_u(args->hit, 1, 0),
                RTCHitN_v(args->hit, 1, 0), RTCRayN_time(args->ray, 1, 0),
                Vec3f(RTCRayN_dir_x(args->ray, 1, 0), RTCRayN_dir_y(args->ray, 1, 0),
                      RTCRayN_dir_z(args->ray, 1, 0)))) {
            args->valid[0] = 0;
        } else if (!scene.true_radii.empty() && RTCRayN_id(args->ray, 1, 0) != 0) {
            pass_by_chance(scene, args);
        }
    }

    /// Rejects a hit with a probability hashed from ray and segment, so that a segment
    /// that Embree meets twice gives the same answer.
    static void pass_by_chance(const SceneShape& scene,
                               const RTCFilterFunctionNArguments* args) {
        const std::uint32_t segment = RTCHitN_primID(args->hit, 1, 0);
        const float u = RTCHitN_u(args->hit, 1, 0);
        const float time = RTCRayN_time(args->ray, 1, 0);
        const float opacity =
            scene.opacity(segment, u, scene.axis(segment, u, time).value.w());
        const auto bits = [](float x, float y) {
            return std::uint64_t(std::bit_cast<std::uint32_t>(x)) << 32 |
                   std::bit_cast<std::uint32_t>(y);
        };
        const std::uint64_t from =
            mix(bits(RTCRayN_org_x(args->ray, 1, 0), RTCRayN_org_y(args->ray, 1, 0)),
                bits(RTCRayN_org_z(args->ray, 1, 0), time));
        const std::uint64_t to =
            mix(bits(RTCRayN_dir_x(args->ray, 1, 0), RTCRayN_dir_y(args->ray, 1, 0)),
                bits(RTCRayN_dir_z(args->ray, 1, 0), 0));
        if (unit_float(std::uint32_t(mix(mix(from, to), segment) >> 32)) >= opacity) {
            args->valid[0] = 0;
        }
    }
};

namespace {

/// Builds the BVH and reports its progress.
void commit(RTCScene scene, const std::function<void(double)>& progress) {
    struct Monitor {
        const std::function<void(double)>& progress;
        std::mutex mutex;
    } monitor{progress, {}};
    const auto report = [](void* data, double done) {
        auto& self = *static_cast<Monitor*>(data);
        // Skipped while another thread reports.
        const std::unique_lock lock(self.mutex, std::try_to_lock);
        if (lock) self.progress(std::clamp(done, 0.0, 1.0));
        return true;
    };
    if (progress) rtcSetSceneProgressMonitorFunction(scene, report, &monitor);
    rtcCommitScene(scene);
    rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
}

}  // namespace

HairScene::HairScene(const Curves& curves, const TriangleMesh* mesh,
                     const HairSceneOptions& options)
    : HairScene(std::array{SceneTime{&curves, mesh}}, options) {}

HairScene::HairScene(std::span<const SceneTime> times, const HairSceneOptions& options)
    : impl_(std::make_unique<Impl>()) {
    check_scene(times, options);
    impl_->shape.true_radii = options.true_radii;
    impl_->shape.aspect = options.aspect;
    const auto start = std::chrono::steady_clock::now();
    for (const SceneTime& time : times) impl_->shape.curves.push_back(time.curves);
    impl_->device = rtcNewDevice(nullptr);
    if (!impl_->device) throw std::runtime_error("Embree cannot start on this machine");
    rtcSetDeviceMemoryMonitorFunction(
        impl_->device,
        [](void* bytes, ssize_t change, bool) {
            *static_cast<std::atomic<std::ptrdiff_t>*>(bytes) += change;
            return true;
        },
        &impl_->bytes);
    impl_->scene = rtcNewScene(impl_->device);
    if (times.size() * times[0].curves->segments.size() >= options.compact_from) {
        rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_COMPACT);
    }
    if (times[0].curves->segments.size() > 0) impl_->add_strands(options.tessellation);
    if (times[0].mesh && !times[0].mesh->triangles.empty()) {
        impl_->shape.mesh = *times[0].mesh;
        for (const SceneTime& time : times.subspan(1)) {
            impl_->shape.vertices.push_back(time.mesh->positions);
        }
        for (const SceneTime& time : times) {
            if (options.crease > 0) {
                impl_->shape.normals.push_back(corner_normals(
                    time.mesh->triangles, time.mesh->positions, options.crease));
            }
        }
        impl_->add_mesh();
    }
    commit(impl_->scene, options.progress);
    impl_->check("building");
    impl_->build_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

HairScene::~HairScene() = default;
HairScene::HairScene(HairScene&&) noexcept = default;
HairScene& HairScene::operator=(HairScene&&) noexcept = default;

std::optional<Hit> HairScene::intersect(const Ray& ray) const {
    RTCRayHit query{};
    query.ray = embree_ray(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    first_hit(impl_->scene, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    Hit hit;
    hit.primitive = query.hit.primID;
    hit.u = query.hit.u;
    hit.v = query.hit.v;
    hit.distance = query.ray.tfar;
    hit.position = ray.origin + query.ray.tfar * ray.direction;
    hit.normal = Vec3f(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
    if (query.hit.geomID == impl_->strands_id) {
        impl_->shape.complete_strand(ray, hit);
    } else {
        impl_->shape.complete_mesh(ray, hit);
    }
    return hit;
}

bool HairScene::occluded(const Ray& ray) const {
    RTCRay query = embree_ray(ray);
    any_hit(impl_->scene, &query);
    return query.tfar < 0;
}

bool HairScene::has_thin_strands() const { return !impl_->shape.true_radii.empty(); }

bool HairScene::moves() const { return impl_->shape.times() > 1; }

Eigen::AlignedBox3f HairScene::bounds() const {
    RTCBounds b;
    rtcGetSceneBounds(impl_->scene, &b);
    return {Vec3f(b.lower_x, b.lower_y, b.lower_z),
            Vec3f(b.upper_x, b.upper_y, b.upper_z)};
}

std::size_t HairScene::bvh_bytes() const { return std::size_t(impl_->bytes.load()); }

double HairScene::build_seconds() const { return impl_->build_seconds; }

}  // namespace lancret
