#include "render_test/embree_scene.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "render_test/sampler.h"
#include "render_test/scene_checks.h"
#include "render_test/strand_axis.h"
#include "render_test/thin_strands.h"

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
    const bool flat = curves.shape == CurveShape::flat;
    if (curves.basis == CurveBasis::bspline)
        return flat ? RTC_GEOMETRY_TYPE_FLAT_BSPLINE_CURVE
                    : RTC_GEOMETRY_TYPE_ROUND_BSPLINE_CURVE;
    return flat ? RTC_GEOMETRY_TYPE_FLAT_HERMITE_CURVE
                : RTC_GEOMETRY_TYPE_ROUND_HERMITE_CURVE;
}

/// `v` without its part along the unit vector `axis`, made unit; any vector across `axis`
/// where nothing is left.
Vec3f unit_across(const Vec3f& v, const Vec3f& axis) {
    const Vec3f across = v - axis * axis.dot(v);
    const float length = across.norm();
    return length > 1e-6f ? Vec3f(across / length) : Vec3f(axis.unitOrthogonal());
}

/// Between which times a ray is, and how far.
struct TimeSegment {
    std::size_t from = 0;
    float share = 0;
};

/// As Embree divides the time of a scene of `times` times.
TimeSegment time_segment(float time, std::size_t times) {
    const float scaled = time * float(times - 1);
    const float from = std::clamp(std::floor(scaled), 0.0f, float(times - 2));
    return {std::size_t(from), scaled - from};
}

}  // namespace

struct HairScene::Impl {
    std::vector<const Curves*> curves;         ///< [times]
    TriangleMesh mesh;                         ///< at the first time
    std::vector<std::vector<Vec3f>> vertices;  ///< [times after the first]
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::span<const float> true_radii;
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

    std::size_t times() const { return curves.size(); }

    void add_strands(int tessellation) {
        const Curves& first = *curves[0];
        const RTCGeometry g = rtcNewGeometry(device, geometry_type(first));
        if (times() > 1) rtcSetGeometryTimeStepCount(g, unsigned(times()));
        const auto share = [&](RTCBufferType type, unsigned slot, const auto& buffer) {
            rtcSetSharedGeometryBuffer(g, type, slot, RTC_FORMAT_FLOAT4, buffer.data(), 0,
                                       sizeof(Point4f), buffer.size());
        };
        for (unsigned t = 0; t < times(); ++t) {
            share(RTC_BUFFER_TYPE_VERTEX, t, curves[t]->points);
            if (first.basis == CurveBasis::hermite)
                share(RTC_BUFFER_TYPE_TANGENT, t, curves[t]->tangents);
        }
        rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                                   first.segments.data(), 0, sizeof(std::uint32_t),
                                   first.segments.size());
        if (!true_radii.empty()) {
            rtcSetGeometryUserData(g, this);
            rtcSetGeometryIntersectFilterFunction(g, pass_by_chance);
            rtcSetGeometryOccludedFilterFunction(g, pass_by_chance);
        }
        if (first.shape == CurveShape::flat)
            rtcSetGeometryTessellationRate(g, float(tessellation));
        strands_id = attach(g, "adding strands");
    }

    const std::vector<Vec3f>& vertices_at(std::size_t time) const {
        return time == 0 ? mesh.positions : vertices[time - 1];
    }

    /// A copy, because Embree reads 16 bytes at the last vertex.
    void add_mesh() {
        const RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        if (times() > 1) rtcSetGeometryTimeStepCount(g, unsigned(times()));
        for (unsigned t = 0; t < times(); ++t) {
            const std::vector<Vec3f>& from = vertices_at(t);
            void* positions =
                rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, t, RTC_FORMAT_FLOAT3,
                                        sizeof(Vec3f), from.size());
            if (positions) std::ranges::copy(from, static_cast<Vec3f*>(positions));
        }
        void* triangles = rtcSetNewGeometryBuffer(
            g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
            sizeof(std::array<std::uint32_t, 3>), mesh.triangles.size());
        if (triangles)
            std::ranges::copy(mesh.triangles,
                              static_cast<std::array<std::uint32_t, 3>*>(triangles));
        attach(g, "adding a mesh");
    }

    /// The share of what is drawn there that a strand truly covers.
    float opacity(std::uint32_t segment, float u, float drawn) const {
        const float true_radius = radius_at(*curves[0], true_radii, segment, u);
        return drawn > 0 ? std::clamp(true_radius / drawn, 0.0f, 1.0f) : 1.0f;
    }

    /// Embree's question whether a hit counts. The chance is the ray's and the segment's,
    /// so that a segment which Embree meets twice gives one answer.
    static void pass_by_chance(const RTCFilterFunctionNArguments* args) {
        if (args->N != 1 || !args->valid[0] || RTCRayN_id(args->ray, 1, 0) == 0) return;
        const Impl& scene = *static_cast<const Impl*>(args->geometryUserPtr);
        const std::uint32_t segment = RTCHitN_primID(args->hit, 1, 0);
        const float u = RTCHitN_u(args->hit, 1, 0);
        const float time = RTCRayN_time(args->ray, 1, 0);
        const float opacity =
            scene.opacity(segment, u, scene.axis_of(segment, u, time).value.w());
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
        if (unit_float(std::uint32_t(mix(mix(from, to), segment) >> 32)) >= opacity)
            args->valid[0] = 0;
    }

    AxisPoint axis_of(std::uint32_t segment, float u, float time) const {
        if (times() == 1) return axis_point(*curves[0], segment, u);
        const auto [from, share] = time_segment(time, times());
        return axis_point(*curves[from], *curves[from + 1], share, segment, u);
    }

    Vec3f vertex(std::uint32_t i, float time) const {
        if (times() == 1) return mesh.positions[i];
        const auto [from, share] = time_segment(time, times());
        return (1 - share) * vertices_at(from)[i] + share * vertices_at(from + 1)[i];
    }

    void complete_strand(const RTCHit& from, const Ray& ray, Hit& hit) const {
        hit.kind = Hit::Kind::strand;
        hit.strand = curves[0]->id_of(curves[0]->strand_of(from.primID));
        const AxisPoint axis = axis_of(from.primID, from.u, ray.time);
        hit.radius = axis.value.w();
        hit.along = (float(from.primID % curves[0]->segments_per_strand) + from.u) /
                    float(curves[0]->segments_per_strand);
        if (!true_radii.empty() && !ray.by_chance)
            hit.opacity = opacity(from.primID, from.u, hit.radius);
        const Vec3f along = axis.derivative.head<3>();
        const float speed = along.norm();
        hit.tangent =
            speed > 0 ? Vec3f(along / speed) : Vec3f(ray.direction.unitOrthogonal());
        hit.facing = unit_across(-ray.direction, hit.tangent);
        const Vec3f across = hit.facing.cross(hit.tangent);
        if (curves[0]->shape == CurveShape::flat) {
            hit.normal = hit.facing;
            hit.h = std::clamp(-from.v, -1.0f, 1.0f);
            hit.offset = hit.h * hit.radius * across;
        } else {
            hit.normal = Vec3f(from.Ng_x, from.Ng_y, from.Ng_z).normalized();
            const Vec3f outward = unit_across(hit.normal, hit.tangent);
            hit.h = std::clamp(outward.dot(across), -1.0f, 1.0f);
            hit.offset = hit.radius * outward;
        }
    }

    void complete_mesh(const RTCHit& from, const Ray& ray, Hit& hit) const {
        hit.kind = Hit::Kind::mesh;
        const auto& corners = mesh.triangles[from.primID];
        const Vec3f a = vertex(corners[0], ray.time);
        hit.tangent = (vertex(corners[1], ray.time) - a).normalized();
        hit.normal = Vec3f(from.Ng_x, from.Ng_y, from.Ng_z).normalized();
        if (mesh.uvs.empty()) return;
        const auto& uv = mesh.uvs[from.primID];
        hit.uv = (1 - from.u - from.v) * uv[0] + from.u * uv[1] + from.v * uv[2];
    }
};

HairScene::HairScene(const Curves& curves, const TriangleMesh* mesh,
                     const HairSceneOptions& options)
    : HairScene(std::array{SceneTime{&curves, mesh}}, options) {}

HairScene::HairScene(std::span<const SceneTime> times, const HairSceneOptions& options)
    : impl_(std::make_unique<Impl>()) {
    if (times.empty() || times.size() > kMostSceneTimes)
        throw std::invalid_argument("a scene has 1 to 129 times");
    if (!times[0].curves) throw std::invalid_argument("a scene needs strands");
    check_indices(*times[0].curves, times[0].mesh);
    for (const SceneTime& time : times.subspan(1)) check_alike(times[0], time);
    if (options.tessellation < 1 || options.tessellation > 16)
        throw std::invalid_argument("tessellation must be 1 to 16");
    if (!options.true_radii.empty() &&
        options.true_radii.size() != times[0].curves->points.size())
        throw std::invalid_argument("true radii are one for each control point");
    impl_->true_radii = options.true_radii;
    const auto start = std::chrono::steady_clock::now();
    for (const SceneTime& time : times) impl_->curves.push_back(time.curves);
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
    if (times[0].curves->segments.size() > 0) impl_->add_strands(options.tessellation);
    if (times[0].mesh && !times[0].mesh->triangles.empty()) {
        impl_->mesh = *times[0].mesh;
        for (const SceneTime& time : times.subspan(1))
            impl_->vertices.push_back(time.mesh->positions);
        impl_->add_mesh();
    }
    rtcCommitScene(impl_->scene);
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
    if (query.hit.geomID == impl_->strands_id)
        impl_->complete_strand(query.hit, ray, hit);
    else
        impl_->complete_mesh(query.hit, ray, hit);
    return hit;
}

bool HairScene::occluded(const Ray& ray) const {
    RTCRay query = embree_ray(ray);
    any_hit(impl_->scene, &query);
    return query.tfar < 0;
}

bool HairScene::has_thin_strands() const { return !impl_->true_radii.empty(); }

bool HairScene::moves() const { return impl_->times() > 1; }

Eigen::AlignedBox3f HairScene::bounds() const {
    RTCBounds b;
    rtcGetSceneBounds(impl_->scene, &b);
    return {Vec3f(b.lower_x, b.lower_y, b.lower_z),
            Vec3f(b.upper_x, b.upper_y, b.upper_z)};
}

std::size_t HairScene::bvh_bytes() const { return std::size_t(impl_->bytes.load()); }

double HairScene::build_seconds() const { return impl_->build_seconds; }

}  // namespace lancret
