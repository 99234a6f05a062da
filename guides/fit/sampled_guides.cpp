#include "guides/fit/sampled_guides.h"

#include <algorithm>
#include <cmath>

#include "guides/strand/rotation_minimizing.h"

namespace lancret {

namespace {

/// Maximum twist of a segment, radian.
constexpr double kMaxTwist = 1;

/// Bend of a segment, radian, below which the chord does not determine its twist.
constexpr double kMinBend = 0.02;

/// The Darboux vector of the helix of length `ds` whose end has the tangent of `turn`,
/// and the twist about it that brings the end nearest to `chord` (cm), all in the frame
/// at its start. By Gauss-Newton steps on the one angle, damped if the segment hardly
/// bends: its twist is then undetermined and would fit noise.
Vec3 twisted(const Mat3& turn, const Vec3& chord, double ds) {
    const auto helix = [&](double twist) -> Vec3 {
        const Mat3 end =
            turn * Eigen::AngleAxisd(twist, Vec3::UnitX()).toRotationMatrix();
        return rotation_log<double>(end) / ds;
    };
    constexpr double kDelta = 1e-4;
    constexpr int kSteps = 4;
    double twist = 0;
    for (int step = 0; step < kSteps; ++step) {
        const Vec3 off = chord - helix_step<double>(helix(twist), ds).displacement;
        const Vec3 slope = (helix_step<double>(helix(twist + kDelta), ds).displacement -
                            helix_step<double>(helix(twist - kDelta), ds).displacement) /
                           (2 * kDelta);
        // Twist moves the end off the plane by a twelfth of bend times length.
        const double least = kMinBend * ds / 12;
        twist += slope.dot(off) / (slope.squaredNorm() + least * least);
        twist = std::clamp(twist, -kMaxTwist, kMaxTwist);
    }
    return helix(twist);
}

}  // namespace

FittedGuide read_super_helix(const SampledCurve& target, const Vec3& surface_tangent) {
    const std::size_t n = target.tangents.size() - 1;
    const double ds = target.step();
    FittedGuide out;
    out.root_frame = frame_from_normal(surface_tangent, target.tangents[0]);
    out.curvatures.resize(n);
    HelixState<double> state{out.root_frame, target.positions[0]};
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        // From the end of the helices so far, so that round-off does not accumulate.
        const Mat3 turn =
            smallest_rotation<double>(state.frame.col(0), target.tangents[i + 1]);
        const Vec3 chord =
            state.frame.transpose() * (target.positions[i + 1] - target.positions[i]);
        const Vec3 u = twisted(state.frame.transpose() * turn * state.frame, chord, ds);
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

FittedGuides sample_guides(const Strands& strands, std::span<const std::uint32_t> which,
                           std::span<const Vec3> surface_tangents, int segments) {
    return guides_of_strands(strands, which, surface_tangents, segments, segments,
                             read_super_helix);
}

}  // namespace lancret
