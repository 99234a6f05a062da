#include "procedural/check/guides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace lancret {

GuideCheck check_guides(const Guides& now, const Guides& rest,
                        std::span<const Vec3> scalp_roots) {
    if (now.size() != rest.size() || now.segments != rest.segments ||
        scalp_roots.size() != now.size()) {
        throw std::invalid_argument(
            "check_guides: not the guides that were given at rest");
    }
    GuideCheck out;
    for (std::size_t g = 0; g < now.size(); ++g) {
        const Mat3& frame = now.root_frames[g];
        out.finite = out.finite && now.root_positions[g].allFinite() && frame.allFinite();
        const double error =
            (frame.transpose() * frame - Mat3::Identity()).cwiseAbs().maxCoeff();
        out.orthogonality = std::max(out.orthogonality, error);
        const double distance = (now.root_positions[g] - scalp_roots[g]).norm();
        if (distance > out.root_distance) {
            out.root_distance = distance;
            out.worst_root = std::uint32_t(g);
        }
    }
    for (std::size_t i = 0; i < now.curvatures.size(); ++i) {
        out.finite = out.finite && now.curvatures[i].allFinite();
        const double was = rest.segment_lengths[i];
        out.length_change =
            std::max(out.length_change, std::abs(now.segment_lengths[i] / was - 1));
    }
    return out;
}

bool passes(const GuideCheck& check, const CheckTolerances& tolerances) {
    return check.finite && check.orthogonality <= tolerances.orthogonality &&
           check.length_change == 0 &&
           (!check.root_applies || check.root_distance <= tolerances.root);
}

}  // namespace lancret
