#pragma once
// The input and the report of `lancret rod`. Dimensionless: the rod's length, EI_1 and
// rho S are 1; gravity points along -z with strength gamma.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/equilibrium/equilibrium.h"
#include "sim/equilibrium/release.h"
#include "sim/equilibrium/stability.h"

namespace lancret {

struct RodSetup {
    double gamma = 0;             ///< rho S g L^3 / EI_1, >= 0
    Vec3 natural = Vec3::Zero();  ///< k0 (twist), k1, k2, times L
    Vec3 root_tangent = Vec3::UnitX();
    std::optional<Vec3> root_normal;  ///< n1, made perpendicular by rod_of; nullopt: z
    double torsion_ratio = 2. / 3;    ///< GJ / EI_1
    double bending_ratio = 1;         ///< EI_2 / EI_1
    int segments = 20;
    double damping = 0;  ///< mu, in sqrt(rho S L^4 / EI_1)
};

/// The rod of a setup. Throws an InputError that names the option if a tangent or normal
/// is zero, the normal is along the tangent, or a number is out of range.
HangingRod rod_of(const RodSetup& setup);

struct RodReport {
    RodSetup setup;
    HangingRod rod;
    RodEquilibrium equilibrium;
    std::vector<double> modes;  ///< at most the requested number
    std::optional<std::vector<StabilityChange>> changes;  ///< nullopt: not requested
    double max_gamma = 0;                                 ///< end of the searched range
    std::optional<RodRelease> release;                    ///< nullopt: not requested
};

/// Largest gamma of a rod and of the search for buckling.
inline constexpr double kMaxGamma = 1e6;

/// The first gamma at which stability is lost; nullopt if it never is.
std::optional<double> critical_gamma(const RodReport& report);

/// The largest |E - E0| of a release divided by E0 - E of the equilibrium; nullopt if the
/// equilibrium is unknown or not below the natural shape.
std::optional<double> energy_drift(const RodReport& report);

/// The report as a table and as JSON.
std::string rod_table(const RodReport& report);
nlohmann::json rod_json(const RodReport& report);

}  // namespace lancret
