#pragma once

#include "procedural/curves/curves.h"

namespace lancret::test {

/// A box that contains B-spline strands with their widths, cm: that of their control
/// points.
inline Eigen::AlignedBox3f box_of(const Curves& curves) {
    Eigen::AlignedBox3f box;
    for (const Point4f& p : curves.points.span()) {
        const Vec3f radius = Vec3f::Constant(p.w);
        box.extend(p.xyz() - radius).extend(p.xyz() + radius);
    }
    return box;
}

}  // namespace lancret::test
