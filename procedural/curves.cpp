#include "procedural/curves.h"

namespace lancret {

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
        if (curves.basis == CurveBasis::catmull_rom) {
            const std::size_t in_strand = i % curves.points_per_strand;
            if (in_strand == 0 || in_strand + 1 == curves.points_per_strand) continue;
            const Vec3f sixth =
                (curves.points[i + 1].xyz() - curves.points[i - 1].xyz()) / 6;
            box.extend(p - sixth - radius).extend(p - sixth + radius);
            box.extend(p + sixth - radius).extend(p + sixth + radius);
        }
    }
    return box;
}

}  // namespace lancret
