#include "bench/render_test/bare_embree.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace lancret::bench {

struct BareEmbree::Impl {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);
    ~Impl() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    void add(RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
    }
};

BareEmbree::BareEmbree(const Curves& curves, const TriangleMesh& mesh, int tessellation)
    : impl_(std::make_unique<Impl>()) {
    const RTCGeometry strands =
        rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_FLAT_BSPLINE_CURVE);
    rtcSetSharedGeometryBuffer(strands, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                               curves.points.data(), 0, sizeof(Point4f),
                               curves.points.size());
    rtcSetSharedGeometryBuffer(strands, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                               curves.segments.data(), 0, sizeof(std::uint32_t),
                               curves.segments.size());
    rtcSetGeometryTessellationRate(strands, float(tessellation));
    impl_->add(strands);
    const RTCGeometry ball = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<Vec3f*>(
        rtcSetNewGeometryBuffer(ball, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Vec3f), mesh.positions.size()));
    std::ranges::copy(mesh.positions, positions);
    using Triangle = std::array<std::uint32_t, 3>;
    auto* triangles = static_cast<Triangle*>(
        rtcSetNewGeometryBuffer(ball, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(Triangle), mesh.triangles.size()));
    std::ranges::copy(mesh.triangles, triangles);
    impl_->add(ball);
    rtcCommitScene(impl_->scene);
}

BareEmbree::~BareEmbree() = default;

std::size_t BareEmbree::trace(std::span<const TracedRay> rays) const {
    std::size_t hits = 0;
    for (const TracedRay& traced : rays) {
        const Ray& from = traced.ray;
        RTCRayHit hit;
        RTCRay& r = hit.ray;
        r.org_x = from.origin.x(), r.org_y = from.origin.y(), r.org_z = from.origin.z();
        r.dir_x = from.direction.x(), r.dir_y = from.direction.y();
        r.dir_z = from.direction.z();
        r.tnear = from.near, r.tfar = from.far, r.time = 0, r.mask = ~0u, r.flags = 0;
        hit.hit.geomID = hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
        if (traced.shadow) {
            rtcOccluded1(impl_->scene, &r);
        } else {
            rtcIntersect1(impl_->scene, &hit);
        }
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        if (traced.shadow) {
            rtcOccluded1(impl_->scene, &context, &r);
        } else {
            rtcIntersect1(impl_->scene, &context, &hit);
        }
#endif
        hits += traced.shadow ? r.tfar < 0 : hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return hits;
}

}  // namespace lancret::bench
