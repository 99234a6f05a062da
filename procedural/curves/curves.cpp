#include "procedural/curves/curves.h"

#include <limits>
#include <stdexcept>

#include "procedural/curves/control_points.h"

namespace lancret {

void Curves::add_class(std::uint32_t count, std::uint32_t intervals) {
    if (count == 0) return;
    const CurveClass own{strands,
                         std::uint32_t(segment_count()),
                         std::uint32_t(point_count()),
                         count,
                         intervals,
                         control_points_of(basis, intervals)};
    if (own.point + std::size_t(count) * own.points >
        std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument("curves: more control points than 32 bits can count");
    }
    classes.push_back(own);
    strands += count;
}

std::size_t Curves::segment_count() const {
    if (classes.empty()) return 0;
    const CurveClass& last = classes.back();
    return last.segment + std::size_t(last.strands) * last.segments;
}

std::size_t Curves::point_count() const {
    if (classes.empty()) return 0;
    const CurveClass& last = classes.back();
    return last.point + std::size_t(last.strands) * last.points;
}

Eigen::AlignedBox3f bounds(const Curves& curves) {
    Eigen::AlignedBox3f box;
    for (std::size_t i = 0; i < curves.points.size(); ++i) {
        const Vec3f p = curves.points[i].xyz(),
                    radius = Vec3f::Constant(curves.points[i].w);
        box.extend(p - radius).extend(p + radius);
        if (curves.basis == CurveBasis::hermite) {
            // The inner Bezier points on either side.
            const Vec3f third = curves.tangents[i].xyz() / 3;
            box.extend(p - third - radius).extend(p - third + radius);
            box.extend(p + third - radius).extend(p + third + radius);
        }
    }
    if (curves.basis != CurveBasis::catmull_rom) return box;
    for (std::uint32_t i = 0; i < curves.strands; ++i) {
        const auto strand = curves.of_strand(curves.points, i);
        for (std::size_t j = 1; j + 1 < strand.size(); ++j) {
            const Vec3f p = strand[j].xyz(), radius = Vec3f::Constant(strand[j].w);
            const Vec3f sixth = (strand[j + 1].xyz() - strand[j - 1].xyz()) / 6;
            box.extend(p - sixth - radius).extend(p - sixth + radius);
            box.extend(p + sixth - radius).extend(p + sixth + radius);
        }
    }
    return box;
}

}  // namespace lancret
