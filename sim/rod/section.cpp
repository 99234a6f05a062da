#include "sim/rod/section.h"

#include <cmath>

#include "guides/base/errors.h"

namespace lancret {

RodSection rod_section(const RodMaterial& material, Dissipation form, double damping) {
    const auto& [young, poisson, a1, a2, density] = material;
    // Written so that a NaN fails.
    const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
    require(positive(young) && positive(a1) && positive(a2) && positive(density),
            "rod_section: modulus, radii and density must be finite and above 0");
    require(poisson > -1 && poisson <= 0.5,
            "rod_section: Poisson's ratio must be in (-1, 0.5]");
    require(damping >= 0 && std::isfinite(damping),
            "rod_section: damping must be finite and at least 0");
    const double shear = young / (2 * (1 + poisson));
    const double torsion = kPi * std::pow(a1 * a2, 3) / (a1 * a1 + a2 * a2);
    RodSection out;
    out.stiffness = {shear * torsion, young * kPi / 4 * a1 * a2 * a2 * a2,
                     young * kPi / 4 * a1 * a1 * a1 * a2};
    out.damping = form == Dissipation::uniform ? Vec3::Constant(damping)
                                               : Vec3(damping * out.stiffness);
    out.linear_density = density * kPi * a1 * a2;
    return out;
}

}  // namespace lancret
