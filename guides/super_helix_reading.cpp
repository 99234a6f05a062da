#include "guides/super_helix_reading.h"

#include "guides/rotation_minimizing.h"

namespace lancret {

FittedGuide read_super_helix(const SampledCurve& target, const Vec3& surface_tangent) {
    const std::size_t n = target.tangents.size() - 1;
    const double ds = target.step();
    FittedGuide out;
    out.root_frame = frame_from_normal(surface_tangent, target.tangents[0]);
    out.curvatures.resize(n);
    HelixState<double> state{out.root_frame, target.positions[0]};
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        // From where the row of arcs has come to, so that round-off does not add up.
        const Vec3 tangent = state.frame.col(0);
        const Mat3 turn = smallest_rotation<double>(tangent, target.tangents[i + 1]);
        // A rotation vector across the tangent has no twist but for round-off.
        Vec3 u = state.frame.transpose() * rotation_log<double>(turn) / ds;
        u.x() = 0;
        out.curvatures[i] = u;
        advance<double>(state, u, ds);
        orthonormalize<double>(state.frame);
        const double distance = (state.position - target.positions[i + 1]).norm();
        sum += distance * distance;
        out.report.max = std::max(out.report.max, distance);
    }
    out.report.length = target.length;
    out.report.rms = std::sqrt(sum / double(n));
    return out;
}

FittedGuides read_guides(const Strands& strands, std::span<const std::uint32_t> which,
                         std::span<const Vec3> surface_tangents, int segments) {
    return guides_of_strands(strands, which, surface_tangents, segments, segments,
                             read_super_helix);
}

}  // namespace lancret
