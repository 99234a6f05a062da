#pragma once
// The material of a hair and the constants of a Super-Helix that follow from it.

#include "guides/base/named.h"
#include "guides/base/types.h"

namespace lancret {

/// A homogeneous hair of elliptic cross-section [Bergbom07, Sec. 4.2.1].
struct RodMaterial {
    double young_modulus = 4e10;  ///< E, dyn/cm^2
    double poisson_ratio = 0.48;  ///< sigma
    double radius1 = 0.004;       ///< a1, the half axis along n1, cm
    double radius2 = 0.004;       ///< a2, the half axis along n2, cm
    double density = 1.3;         ///< rho, g/cm^3
};

/// How changes of curvature are damped: the dissipation is half the integral of
/// sum_i d_i k_i'^2.
enum class Dissipation {
    viscoelastic,  ///< d_i = mu (EI)_i, mu in seconds [Bergbom07, Eq. 4.29]
    uniform,       ///< d_i = gamma, dyn cm^2 s [Bergbom07, Eq. 4.28]
};
inline constexpr Named<Dissipation> kDissipationNames[] = {
    {Dissipation::viscoelastic, "viscoelastic"}, {Dissipation::uniform, "uniform"}};

/// The constants of a rod per unit of its length.
struct RodSection {
    Vec3 stiffness = Vec3::Ones();  ///< against (k0, k1, k2), dyn cm^2
    Vec3 damping = Vec3::Zero();    ///< against (k0', k1', k2'), dyn cm^2 s
    double linear_density = 1;      ///< rho S, g/cm
};

/// The constants of `material`: (GJ, EI_1, EI_2) with the shear modulus
/// E / 2 (1 + sigma), and rho S. `damping` is mu (s) or gamma (dyn cm^2 s). Throws
/// std::invalid_argument if a constant is not finite, a modulus, radius or density is
/// not above 0, sigma is outside (-1, 0.5], or the damping is below 0.
RodSection rod_section(const RodMaterial& material, Dissipation form, double damping);

}  // namespace lancret
