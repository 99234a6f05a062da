#include "render_test/scene_checks.h"

#include <algorithm>
#include <stdexcept>

namespace lancret {

void check_indices(const Curves& curves, const TriangleMesh* mesh) {
    const bool hermite = curves.basis == CurveBasis::hermite;
    const std::size_t reach = hermite ? 2 : 4;
    if (hermite && curves.tangents.size() != curves.points.size())
        throw std::invalid_argument("Hermite strands need one tangent a point");
    if ((curves.shape == CurveShape::ribbon || curves.normals.size() > 0) &&
        (hermite || curves.normals.size() != curves.points.size()))
        throw std::invalid_argument(
            "strands with a face are B-splines with one normal a point");
    if (curves.segments.size() !=
        std::size_t(curves.strands) * curves.segments_per_strand)
        throw std::invalid_argument("strands times segments a strand is not the count");
    std::size_t segment = 0;
    for (std::size_t i = 0; i < curves.strands; ++i)
        for (std::size_t j = 0; j < curves.segments_per_strand; ++j) {
            const std::size_t first = curves.segments[segment++];
            if (first + reach > curves.points.size())
                throw std::invalid_argument(
                    "a strand segment points past the control points");
            if (first != i * curves.points_per_strand + j)
                throw std::invalid_argument(
                    "a strand's segments follow each other, as its points do");
        }
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

void check_alike(const SceneTime& first, const SceneTime& other) {
    if (!other.curves || !other.mesh != !first.mesh)
        throw std::invalid_argument(
            "a scene has strands at all times, a mesh at all or none");
    const Curves &a = *first.curves, &b = *other.curves;
    if (a.basis != b.basis || a.shape != b.shape || a.strands != b.strands ||
        a.points_per_strand != b.points_per_strand ||
        a.points.size() != b.points.size() || a.tangents.size() != b.tangents.size() ||
        a.normals.size() != b.normals.size() ||
        !std::ranges::equal(a.segments.span(), b.segments.span()))
        throw std::invalid_argument("a scene's strands are the same at all times");
    if (first.mesh && (first.mesh->triangles != other.mesh->triangles ||
                       first.mesh->positions.size() != other.mesh->positions.size()))
        throw std::invalid_argument("a scene's mesh has the same triangles at all times");
}

}  // namespace lancret
