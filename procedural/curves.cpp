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
    }
    return box;
}

}  // namespace lancret
