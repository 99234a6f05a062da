#include "sim/segment/point_translation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace lancret {

namespace {

void check(bool fine, const char* what) {
    if (!fine) throw std::invalid_argument(std::string("translate_point: ") + what);
}

}  // namespace

TranslationReport translate_point(const SuperHelix& helix, double s, const Vec3& target,
                                  const TranslationSettings& settings,
                                  std::vector<Vec3>& curvatures) {
    const int segments = int(helix.lengths.size());
    const double length = std::accumulate(helix.lengths.begin(), helix.lengths.end(), 0.);
    check(s >= 0 && s <= length * (1 + 1e-12), "a point of the strand");
    check(target.allFinite(), "a finite target");
    check(settings.stiffness.minCoeff() > 0, "a stiffness above 0");
    const int first = settings.first_segment,
              last = std::min(settings.last_segment, segments - 1);
    check(first >= 0 && first <= last, "segments of the strand");

    curvatures.assign(helix.curvatures.begin(), helix.curvatures.end());
    SuperHelix bent = helix;
    bent.curvatures = curvatures;
    Eigen::VectorXd place;
    Eigen::MatrixXd jacobian;
    const std::span<const double> at(&s, 1);
    positions_with_jacobian(bent, at, place, jacobian);
    Vec3 away = target - place.head<3>();

    TranslationReport report;
    const int columns = 3 * (last - first + 1);
    std::vector<Vec3> tried;
    double damping = 1e-6;
    while (away.norm() > settings.tolerance &&
           report.iterations < settings.most_iterations) {
        ++report.iterations;
        // The normal equations of the bending, seen from the point: three unknowns
        // however many curvatures there are. W is how far a curvature gives.
        const Eigen::Matrix3Xd j = jacobian.middleCols(3 * first, columns);
        Eigen::Matrix3Xd weighted = j;
        for (int q = first; q <= last; ++q) {
            for (int i = 0; i < 3; ++i) {
                weighted.col(3 * (q - first) + i) /=
                    helix.lengths[std::size_t(q)] * settings.stiffness[i];
            }
        }
        const Mat3 gram = weighted * j.transpose();
        const double scale = gram.trace();
        if (!(scale > 0)) break;  // the point cannot move: it is the root
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
            // No segment turns by more than a radian at once: beyond that the Jacobian
            // says nothing.
            if (!(turn <= 1)) continue;
            bent.curvatures = tried;
            const Vec3 next = target - state_at(bent, s).position;
            better = next.squaredNorm() < away.squaredNorm();
        }
        if (!better) break;
        curvatures.swap(tried);
        damping = std::max(damping, 1e-12);
        bent.curvatures = curvatures;
        positions_with_jacobian(bent, at, place, jacobian);
        away = target - place.head<3>();
    }
    report.distance = away.norm();
    report.reached = report.distance <= settings.tolerance;
    return report;
}

}  // namespace lancret
