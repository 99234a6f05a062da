#include "render_test/embree_scene.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "render_test/strand_axis.h"

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
    r.mask = ~0u;
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

void check_indices(const Curves& curves, const TriangleMesh* mesh) {
    const bool hermite = curves.basis == CurveBasis::hermite;
    const std::size_t reach = hermite ? 2 : 4;
    if (hermite && curves.tangents.size() != curves.points.size())
        throw std::invalid_argument("Hermite strands need one tangent a point");
    if (curves.segments.size() !=
        std::size_t(curves.strands) * curves.segments_per_strand)
        throw std::invalid_argument("strands times segments a strand is not the count");
    for (const std::uint32_t first : curves.segments.span())
        if (first + reach > curves.points.size())
            throw std::invalid_argument(
                "a strand segment points past the control points");
    if (!mesh) return;
    if (!mesh->uvs.empty() && mesh->uvs.size() != mesh->triangles.size())
        throw std::invalid_argument("a mesh needs UVs for every triangle or for none");
    for (const auto& corners : mesh->uvs)
        for (const Vec2f& uv : corners)
            if (!uv.allFinite()) throw std::invalid_argument("a mesh's UV is not finite");
    for (const auto& triangle : mesh->triangles)
        for (const std::uint32_t corner : triangle)
            if (corner >= mesh->positions.size())
                throw std::invalid_argument("a triangle points past the vertices");
}

}  // namespace

struct HairScene::Impl {
    const Curves* curves = nullptr;
    TriangleMesh mesh;
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
        const RTCGeometry g = rtcNewGeometry(device, geometry_type(*curves));
        rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                   curves->points.data(), 0, sizeof(Point4f),
                                   curves->points.size());
        if (curves->basis == CurveBasis::hermite)
            rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_TANGENT, 0, RTC_FORMAT_FLOAT4,
                                       curves->tangents.data(), 0, sizeof(Point4f),
                                       curves->tangents.size());
        rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                                   curves->segments.data(), 0, sizeof(std::uint32_t),
                                   curves->segments.size());
        if (curves->shape == CurveShape::flat)
            rtcSetGeometryTessellationRate(g, float(tessellation));
        strands_id = attach(g, "adding strands");
    }

    /// A copy, because Embree reads 16 bytes at the last vertex.
    void add_mesh() {
        const RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* positions =
            rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    sizeof(Vec3f), mesh.positions.size());
        void* triangles = rtcSetNewGeometryBuffer(
            g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
            sizeof(std::array<std::uint32_t, 3>), mesh.triangles.size());
        if (positions && triangles) {
            std::copy(mesh.positions.begin(), mesh.positions.end(),
                      static_cast<Vec3f*>(positions));
            std::copy(mesh.triangles.begin(), mesh.triangles.end(),
                      static_cast<std::array<std::uint32_t, 3>*>(triangles));
        }
        attach(g, "adding a mesh");
    }

    void complete_strand(const RTCHit& from, const Ray& ray, Hit& hit) const {
        hit.kind = Hit::Kind::strand;
        hit.strand = curves->strand_of(from.primID);
        const AxisPoint axis = axis_point(*curves, from.primID, from.u);
        hit.radius = axis.value.w();
        const Vec3f along = axis.derivative.head<3>();
        const float speed = along.norm();
        hit.tangent =
            speed > 0 ? Vec3f(along / speed) : Vec3f(ray.direction.unitOrthogonal());
        hit.facing = unit_across(-ray.direction, hit.tangent);
        const Vec3f across = hit.facing.cross(hit.tangent);
        if (curves->shape == CurveShape::flat) {
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

    void complete_mesh(const RTCHit& from, Hit& hit) const {
        hit.kind = Hit::Kind::mesh;
        const auto& corners = mesh.triangles[from.primID];
        const Vec3f& a = mesh.positions[corners[0]];
        hit.tangent = (mesh.positions[corners[1]] - a).normalized();
        hit.normal = Vec3f(from.Ng_x, from.Ng_y, from.Ng_z).normalized();
        if (mesh.uvs.empty()) return;
        const auto& uv = mesh.uvs[from.primID];
        hit.uv = (1 - from.u - from.v) * uv[0] + from.u * uv[1] + from.v * uv[2];
    }
};

HairScene::HairScene(const Curves& curves, const TriangleMesh* mesh,
                     const HairSceneOptions& options)
    : impl_(std::make_unique<Impl>()) {
    check_indices(curves, mesh);
    if (options.tessellation < 1 || options.tessellation > 16)
        throw std::invalid_argument("tessellation must be 1 to 16");
    const auto start = std::chrono::steady_clock::now();
    impl_->curves = &curves;
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
    if (curves.segments.size() > 0) impl_->add_strands(options.tessellation);
    if (mesh && !mesh->triangles.empty()) {
        impl_->mesh = *mesh;
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
        impl_->complete_mesh(query.hit, hit);
    return hit;
}

bool HairScene::occluded(const Ray& ray) const {
    RTCRay query = embree_ray(ray);
    any_hit(impl_->scene, &query);
    return query.tfar < 0;
}

Eigen::AlignedBox3f HairScene::bounds() const {
    RTCBounds b;
    rtcGetSceneBounds(impl_->scene, &b);
    return {Vec3f(b.lower_x, b.lower_y, b.lower_z),
            Vec3f(b.upper_x, b.upper_y, b.upper_z)};
}

std::size_t HairScene::bvh_bytes() const { return std::size_t(impl_->bytes.load()); }

double HairScene::build_seconds() const { return impl_->build_seconds; }

}  // namespace lancret
