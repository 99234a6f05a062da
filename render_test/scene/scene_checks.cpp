#include "render_test/scene/scene_checks.h"

#include <algorithm>
#include <stdexcept>

namespace lancret {

namespace {

/// Throws if the table of classes does not match the buffers.
void check_classes(const Curves& curves) {
    Curves counted;
    counted.basis = curves.basis;
    for (const CurveClass& c : curves.classes) counted.add_class(c.strands, c.segments);
    if (counted.classes != curves.classes || counted.strands != curves.strands ||
        counted.segment_count() != curves.segments.size()) {
        throw std::invalid_argument(
            "the table of curve classes does not match the buffers");
    }
}

/// `mesh` may be null.
void check_indices(const Curves& curves, const TriangleMesh* mesh) {
    const bool hermite = curves.basis == CurveBasis::hermite;
    const std::size_t reach = hermite ? 2 : 4;
    if (hermite && curves.tangents.size() != curves.points.size()) {
        throw std::invalid_argument("Hermite strands need one tangent per point");
    }
    if ((curves.shape == CurveShape::ribbon || curves.normals.size() > 0) &&
        (hermite || curves.normals.size() != curves.points.size())) {
        throw std::invalid_argument(
            "strands with faces must be B-splines with one normal per point");
    }
    check_classes(curves);
    std::size_t segment = 0;
    for (const CurveClass& c : curves.classes) {
        for (std::size_t i = 0; i < c.strands; ++i) {
            for (std::size_t j = 0; j < c.segments; ++j) {
                const std::size_t first = curves.segments[segment++];
                if (first + reach > curves.points.size()) {
                    throw std::invalid_argument(
                        "a strand segment points past the control points");
                }
                if (first != c.point + i * c.points + j) {
                    throw std::invalid_argument(
                        "the segments of a strand must be consecutive, like its points");
                }
            }
        }
    }
    if (!mesh) return;
    if (!mesh->uvs.empty() && mesh->uvs.size() != mesh->triangles.size()) {
        throw std::invalid_argument("a mesh needs UVs for every triangle or for none");
    }
    for (const auto& corners : mesh->uvs) {
        for (const Vec2f& uv : corners) {
            if (!uv.allFinite()) throw std::invalid_argument("a mesh's UV is not finite");
        }
    }
    for (const auto& triangle : mesh->triangles) {
        for (const std::uint32_t corner : triangle) {
            if (corner >= mesh->positions.size()) {
                throw std::invalid_argument("a triangle points past the vertices");
            }
        }
    }
}

void check_alike(const SceneTime& first, const SceneTime& other) {
    if (!other.curves || !other.mesh != !first.mesh) {
        throw std::invalid_argument(
            "a scene needs strands at all times, and a mesh at all times or none");
    }
    const Curves &a = *first.curves, &b = *other.curves;
    if (a.basis != b.basis || a.shape != b.shape || a.strands != b.strands ||
        a.classes != b.classes || a.points.size() != b.points.size() ||
        a.tangents.size() != b.tangents.size() || a.normals.size() != b.normals.size() ||
        !std::ranges::equal(a.segments.span(), b.segments.span())) {
        throw std::invalid_argument(
            "the strands of a scene must have the same layout at all times");
    }
    if (first.mesh && (first.mesh->triangles != other.mesh->triangles ||
                       first.mesh->positions.size() != other.mesh->positions.size())) {
        throw std::invalid_argument(
            "the mesh of a scene must have the same triangles at all times");
    }
}

}  // namespace

void check_scene(std::span<const SceneTime> times, const HairSceneOptions& options) {
    if (times.empty() || times.size() > kMaxSceneTimes) {
        throw std::invalid_argument("a scene must have 1 to 129 times");
    }
    if (!times[0].curves) throw std::invalid_argument("a scene needs strands");
    const Curves& curves = *times[0].curves;
    check_indices(curves, times[0].mesh);
    for (const SceneTime& time : times.subspan(1)) check_alike(times[0], time);
    if (options.tessellation < 1 || options.tessellation > 16) {
        throw std::invalid_argument("tessellation must be 1 to 16");
    }
    if (!options.true_radii.empty() &&
        options.true_radii.size() != curves.points.size()) {
        throw std::invalid_argument("true radii must be one per control point");
    }
    if (!(options.aspect > 0 && options.aspect <= 1)) {
        throw std::invalid_argument("a strand's aspect must be above 0 and at most 1");
    }
    if (options.aspect < 1 && (curves.shape != CurveShape::flat ||
                               curves.normals.size() != curves.points.size())) {
        throw std::invalid_argument(
            "elliptic strands must be flat, with one normal per point");
    }
}

}  // namespace lancret
