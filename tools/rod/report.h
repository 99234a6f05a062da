#pragma once
// What `lancret rod` asks of one hanging rod, and the answer. Dimensionless: the rod's
// length, EI_1 and rho S are 1, and gravity is -z of strength gamma.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/equilibrium/equilibrium.h"
#include "sim/equilibrium/release.h"
#include "sim/equilibrium/stability.h"

namespace lancret {

struct RodSetup {
    double gamma = 0;             ///< rho S g L^3 / EI_1, 0 or more
    Vec3 natural = Vec3::Zero();  ///< k0 (twist), k1, k2, times L
    Vec3 root_tangent = Vec3::UnitX();
    std::optional<Vec3> root_normal;  ///< n1, before it is made perpendicular; none: z
    double torsion_ratio = 2. / 3;    ///< GJ / EI_1
    double bending_ratio = 1;         ///< EI_2 / EI_1
    int segments = 20;
    double damping = 0;  ///< mu, in sqrt(rho S L^4 / EI_1)
};

/// The rod of a setup. Throws InputError that names the option which cannot be: a zero
/// tangent, a normal along the tangent, a number that is not finite.
HangingRod rod_of(const RodSetup& setup);

struct RodReport {
    RodSetup setup;
    HangingRod rod;
    RodEquilibrium equilibrium;
    std::vector<double> modes;                            ///< as many as asked for
    std::optional<std::vector<StabilityChange>> changes;  ///< none: not asked for
    double max_gamma = 0;               ///< up to which they were looked for
    std::optional<RodRelease> release;  ///< none: not asked for
};

/// The largest gamma, and the largest gamma that is searched for buckling.
inline constexpr double kMaxGamma = 1e6;

/// The first weight at which stability is lost.
std::optional<double> critical_gamma(const RodReport& report);

/// The largest |E - E0| of a release against E0 - E of the equilibrium: none where the
/// equilibrium is not known or no lower than the natural shape.
std::optional<double> energy_drift(const RodReport& report);

/// As a table for people and as JSON.
std::string rod_table(const RodReport& report);
nlohmann::json rod_json(const RodReport& report);

}  // namespace lancret
