#include "sim/segment/point_translation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "guides/base/errors.h"

namespace lancret {

namespace {

/// A strand whose point at arc length s is being moved to a target.
struct MovedPoint {
    const SuperHelix& helix;
    double s;  ///< cm
    Vec3 target;
    Vec3 stiffness;
    int first, last;  ///< segments that may bend

    std::vector<Vec3>& curvatures;  ///< [segments], the current ones
    Eigen::MatrixXd jacobian;
    Vec3 away;  ///< from the point to the target, cm
    double damping = 1e-6;

    /// Finds `away` and `jacobian` of the current curvatures.
    void linearize() {
        const SuperHelix bent{helix.root, helix.lengths, curvatures};
        Eigen::VectorXd position;
        positions_with_jacobian(bent, std::span<const double>(&s, 1), position, jacobian);
        away = target - position.head<3>();
    }

    /// One iteration of Levenberg-Marquardt; false if it does not bring the point nearer.
    bool improve() {
        const int columns = 3 * (last - first + 1);
        // The normal equations of the bending, seen from the point: three unknowns for
        // any number of curvatures. The weights are the compliances of the curvatures.
        const Eigen::Matrix3Xd j = jacobian.middleCols(3 * first, columns);
        Eigen::Matrix3Xd weighted = j;
        for (int q = first; q <= last; ++q) {
            for (int i = 0; i < 3; ++i) {
                weighted.col(3 * (q - first) + i) /=
                    helix.lengths[std::size_t(q)] * stiffness[i];
            }
        }
        const Mat3 gram = weighted * j.transpose();
        const double scale = gram.trace();
        if (!(scale > 0)) return false;  // the point cannot move: it is the root
        std::vector<Vec3> tried;
        bool better = false;
        for (; !better && damping < 1e12; damping *= better ? 0.1 : 10) {
            const Mat3 damped = gram + damping * scale * Mat3::Identity();
            const Eigen::VectorXd change =
                weighted.transpose() * damped.ldlt().solve(away);
            tried = curvatures;
            double turn = 0;
            for (int q = first; q <= last; ++q) {
                const Vec3 k = change.segment<3>(3 * (q - first));
                tried[std::size_t(q)] += k;
                turn = std::max(turn, helix.lengths[std::size_t(q)] * k.norm());
            }
            // No segment may turn by more than a radian at once: the Jacobian does not
            // hold that far.
            if (!(turn <= 1)) continue;
            const SuperHelix bent{helix.root, helix.lengths, tried};
            const Vec3 next = target - state_at(bent, s).position;
            better = next.squaredNorm() < away.squaredNorm();
        }
        if (!better) return false;
        curvatures.swap(tried);
        damping = std::max(damping, 1e-12);
        linearize();
        return true;
    }
};

}  // namespace

TranslationReport translate_point(const SuperHelix& helix, double s, const Vec3& target,
                                  const TranslationSettings& settings,
                                  std::vector<Vec3>& curvatures) {
    const int segments = int(helix.lengths.size());
    const double length = std::accumulate(helix.lengths.begin(), helix.lengths.end(), 0.);
    require(s >= 0 && s <= length * (1 + 1e-12),
            "translate_point: s must be in [0, length]");
    require(target.allFinite(), "translate_point: the target must be finite");
    require(settings.stiffness.minCoeff() > 0,
            "translate_point: stiffness must be above 0");
    const int first = settings.first_segment,
              last = std::min(settings.last_segment, segments - 1);
    require(first >= 0 && first <= last, "translate_point: no such segments");

    curvatures.assign(helix.curvatures.begin(), helix.curvatures.end());
    MovedPoint point{helix, s,          target, settings.stiffness, first,
                     last,  curvatures, {},     Vec3::Zero()};
    point.linearize();
    TranslationReport report;
    while (point.away.norm() > settings.tolerance &&
           report.iterations < settings.max_iterations) {
        ++report.iterations;
        if (!point.improve()) break;
    }
    report.distance = point.away.norm();
    report.reached = report.distance <= settings.tolerance;
    return report;
}

}  // namespace lancret
