#pragma once
// The energy of one Super-Helix under its own weight and its exact derivatives.
//
//     E(q) = 1/2 sum_Q l_Q (k_Q - n_Q)^T K (k_Q - n_Q) - rho S int g . (r - r_root) ds
//
// with natural curvatures n and K the diagonal of the stiffnesses [Bergbom07, Eq. 4.26
// and 4.52]. The terms linear in g are kept apart, so that weight can be scaled.

#include <Eigen/Dense>
#include <vector>

#include "guides/helix/super_helix.h"
#include "sim/rod/section.h"

namespace lancret {

/// One Super-Helix, clamped at its root. Its curvatures are passed separately as a vector
/// q [3 segments]: k0, k1, k2 of segment 0, then of segment 1 and so on, 1/cm.
struct HangingRod {
    HelixState<double> root;
    std::vector<double> lengths;  ///< [segments], cm
    std::vector<Vec3> natural;    ///< [segments], 1/cm
    RodSection section;
    Vec3 gravity = Vec3::Zero();  ///< cm/s^2

    std::size_t segments() const { return lengths.size(); }
};

/// Throws std::invalid_argument if the rod has no segment, arrays of unequal length, a
/// number that is not finite, a length, stiffness or density that is not above 0, or a
/// root frame that is not a rotation to 1e-9.
void validate_rod(const HangingRod& rod);

double rod_length(const HangingRod& rod);
/// The natural curvatures as q.
Eigen::VectorXd natural_curvatures(const HangingRod& rod);
/// K l: [3 segments], erg cm^2.
Eigen::VectorXd stiffness_diagonal(const HangingRod& rod);
/// Frame and position at the start of each segment and, last, at the tip.
std::vector<HelixState<double>> rod_joints(const HangingRod& rod,
                                           const Eigen::VectorXd& q);

struct HangingEnergy {
    double elastic = 0;  ///< erg
    double gravity = 0;  ///< erg; 0 if all mass is at the root

    double total() const { return elastic + gravity; }
};

HangingEnergy rod_energy(const HangingRod& rod, const Eigen::VectorXd& q);

/// The gravitational energy, its gradient -rho S int J^T g ds, and its Hessian.
struct GravityTerms {
    double energy = 0;         ///< erg
    Eigen::VectorXd gradient;  ///< [3 segments]
    Eigen::MatrixXd hessian;   ///< [3 segments, 3 segments], symmetric
};

enum class Derivatives { none, first, second };

/// Sets the terms up to the derivatives of `order`, in O(segments) time, with second
/// derivatives O(segments^2). The quadrature's relative error is below 1e-10; the
/// derivatives are those of the quadrature to within that error.
void gravity_terms(const HangingRod& rod, const Eigen::VectorXd& q, Derivatives order,
                   GravityTerms& out);

/// d2E/dq2 of the whole energy, dense.
Eigen::MatrixXd rod_hessian(const HangingRod& rod, const Eigen::VectorXd& q);

}  // namespace lancret
