#include "guides/mesh/closest_point.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "guides/base/cancel.h"

namespace lancret {

namespace {

struct Nearest {
    double u = 0, v = 0, distance2 = std::numeric_limits<double>::infinity();
};

/// The point of a triangle closest to the origin, given its corners relative to it.
Nearest nearest_to_origin(const std::array<Vec3, 3>& p) {
    const Vec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
    // The least squares over the whole plane: normal equations of |p0 + u e1 + v e2|^2.
    const double a = e1.dot(e1), b = e1.dot(e2), c = e2.dot(e2);
    const double f = -e1.dot(p[0]), g = -e2.dot(p[0]), det = a * c - b * b;
    const double u = (f * c - g * b) / det, v = (g * a - f * b) / det;
    // Also false for the NaN of a triangle without area.
    if (u >= 0 && v >= 0 && u + v <= 1) {
        return {u, v, (p[0] + u * e1 + v * e2).squaredNorm()};
    }
    // Otherwise it is on an edge: corner `from` plus t along d; in (u, v) from `at` along
    // `step`.
    Nearest best;
    const auto edge = [&](const Vec3& from, const Vec3& d, Vec2 at, Vec2 step) {
        const double length2 = d.squaredNorm();
        const double t = length2 > 0 ? std::clamp(-from.dot(d) / length2, 0.0, 1.0) : 0.0;
        const double distance2 = (from + t * d).squaredNorm();
        if (distance2 < best.distance2) {
            const Vec2 uv = at + t * step;
            best = {uv.x(), uv.y(), distance2};
        }
    };
    edge(p[0], e1, {0, 0}, {1, 0});
    edge(p[0], e2, {0, 0}, {0, 1});
    edge(p[1], e2 - e1, {1, 0}, {-1, 1});
    return best;
}

}  // namespace

struct ClosestPoint::Tree {
    TriangleMesh mesh;
    double reach = 0;  ///< the largest coordinate
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    ~Tree() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
    Nearest nearest(std::uint32_t triangle, const Vec3& place) const {
        const auto& t = mesh.triangles[triangle];
        return nearest_to_origin({mesh.positions[t[0]].cast<double>() - place,
                                  mesh.positions[t[1]].cast<double>() - place,
                                  mesh.positions[t[2]].cast<double>() - place});
    }
};

namespace {

/// The state of a query in the tree.
template <class Tree>
struct Search {
    const Tree* tree;
    Vec3 place;
    Nearest best;
    std::uint32_t triangle = 0;

    /// The tree works in float. The radius keeps a margin above the rounding of its boxes
    /// and of the place, so that no triangle is missed that is as near, or nearer, in
    /// double.
    float radius() const {
        const double distance = std::sqrt(best.distance2);
        return float(distance +
                     1e-6 * (distance + tree->reach + place.cwiseAbs().maxCoeff()));
    }
};

/// Tries a triangle and shrinks the search to the best distance so far.
template <class Tree>
bool try_triangle(RTCPointQueryFunctionArguments* args) {
    auto& search = *static_cast<Search<Tree>*>(args->userPtr);
    const Nearest found = search.tree->nearest(args->primID, search.place);
    if (found.distance2 > search.best.distance2 ||
        (found.distance2 == search.best.distance2 && args->primID > search.triangle)) {
        return false;
    }
    search.best = found;
    search.triangle = args->primID;
    args->query->radius = search.radius();
    return true;
}

}  // namespace

ClosestPoint::ClosestPoint(const TriangleMesh& mesh) : tree_(std::make_unique<Tree>()) {
    if (mesh.triangles.empty()) {
        throw std::invalid_argument("ClosestPoint: the mesh has no triangles");
    }
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            if (vertex >= mesh.positions.size()) {
                throw std::invalid_argument("ClosestPoint: an index is out of range");
            }
        }
    }
    tree_->mesh = {mesh.positions, mesh.triangles, {}};
    for (const Vec3f& p : mesh.positions) {
        tree_->reach = std::max(tree_->reach, double(p.cwiseAbs().maxCoeff()));
    }
    tree_->device = rtcNewDevice(nullptr);
    if (!tree_->device) {
        throw std::runtime_error("ClosestPoint: Embree cannot be started");
    }
    tree_->scene = rtcNewScene(tree_->device);
    rtcSetSceneFlags(tree_->scene, RTC_SCENE_FLAG_ROBUST);

    const RTCGeometry geometry =
        rtcNewGeometry(tree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Vec3f), mesh.positions.size()));
    auto* triangles = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.triangles.size()));
    if (!positions || !triangles) throw std::bad_alloc();
    std::copy_n(mesh.positions.data()->data(), 3 * mesh.positions.size(), positions);
    std::copy_n(mesh.triangles.data()->data(), 3 * mesh.triangles.size(), triangles);
    rtcSetGeometryPointQueryFunction(geometry, try_triangle<Tree>);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(tree_->scene, geometry);
    rtcReleaseGeometry(geometry);
    // Embree reads invalid memory in a tree whose build was cut short.
    run_to_completion([&] { rtcCommitScene(tree_->scene); });
    if (rtcGetDeviceError(tree_->device) != RTC_ERROR_NONE) {
        throw std::runtime_error("ClosestPoint: Embree cannot build its tree");
    }
}

ClosestPoint::~ClosestPoint() = default;
ClosestPoint::ClosestPoint(ClosestPoint&&) noexcept = default;
ClosestPoint& ClosestPoint::operator=(ClosestPoint&&) noexcept = default;

ClosestResult ClosestPoint::closest(const Vec3& place, double within) const {
    // No triangle has this index, so one exactly at `within`, after round-off, counts.
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    Search<Tree> search{tree_.get(), place, {}, kNone};
    search.best.distance2 = within * within;
    RTCPointQuery query;
    query.x = float(place.x());
    query.y = float(place.y());
    query.z = float(place.z());
    query.time = 0;
    query.radius = search.radius();
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(tree_->scene, &query, &context, nullptr, &search);

    // If the tree found nothing (a place whose squared distance overflows a float), every
    // triangle is tried.
    if (search.triangle == kNone && std::isinf(search.best.distance2)) {
        for (std::uint32_t i = 0; i < tree_->mesh.triangles.size(); ++i) {
            const Nearest found = tree_->nearest(i, place);
            if (found.distance2 < search.best.distance2) {
                search.best = found;
                search.triangle = i;
            }
        }
    }
    ClosestResult result;
    if (search.triangle == kNone) {
        result.distance = std::numeric_limits<double>::infinity();
        return result;
    }
    const auto& t = tree_->mesh.triangles[search.triangle];
    const Vec3 p0 = tree_->mesh.positions[t[0]].cast<double>();
    const Vec3 e1 = tree_->mesh.positions[t[1]].cast<double>() - p0;
    const Vec3 e2 = tree_->mesh.positions[t[2]].cast<double>() - p0;
    const float u = float(search.best.u);
    result.point = {search.triangle, u, std::min(float(search.best.v), 1 - u)};
    result.position = p0 + search.best.u * e1 + search.best.v * e2;
    result.uv = {search.best.u, search.best.v};
    result.distance = std::sqrt(search.best.distance2);
    return result;
}

}  // namespace lancret
