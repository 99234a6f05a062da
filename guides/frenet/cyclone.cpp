#include "guides/frenet/cyclone.h"

#include <cmath>
#include <complex>
#include <stdexcept>

namespace lancret {

namespace {

void require_radius(const Cyclone& cyclone) {
    if (!(cyclone.radius > 0 && cyclone.length > 0 &&
          cyclone.radius + cyclone.growth * cyclone.length > 0)) {
        throw std::invalid_argument(
            "cyclone: the radius of curvature must be positive from root to tip");
    }
}

}  // namespace

double cyclone_turn(const Cyclone& cyclone, double s) {
    const double grown = cyclone.growth * s / cyclone.radius;
    // As growth goes to 0, log1p(x) / growth tends to s / radius.
    return grown == 0 ? s / cyclone.radius : std::log1p(grown) / cyclone.growth;
}

HelixState<double> cyclone_state(const Cyclone& cyclone, const HelixState<double>& root,
                                 double s) {
    require_radius(cyclone);
    // With w = sqrt(1 + h^2) and l = w q, the tangent is (h A + N sin l - Gamma cos l)
    // / w for Lancret's axis A [TW99, Eq. 21 and 24]. Since ds = radius e^(growth q) dq,
    // the integral of e^(i l) is (radius(s) e^(i l) - radius(0)) / (growth + i w).
    const double h = cyclone.helicity, w = std::hypot(1, h);
    const double q = cyclone_turn(cyclone, s);
    const std::complex<double> wave =
        (std::polar(cyclone.radius + cyclone.growth * s, w * q) - cyclone.radius) /
        std::complex<double>(cyclone.growth, w);
    const Vec3 tangent = root.frame.col(0), normal = root.frame.col(1),
               gamma = (h * root.frame.col(2) - tangent) / w;
    return {root.frame * constant_helicity_rotation(h, q),
            root.position + h / w * s * lancret_axis(root.frame, h) +
                (wave.imag() * normal - wave.real() * gamma) / w};
}

std::vector<HelixState<double>> cyclone_strand(const Cyclone& cyclone,
                                               const HelixState<double>& root, int n) {
    if (n < 1) throw std::invalid_argument("cyclone: expected at least one interval");
    std::vector<HelixState<double>> states;
    for (int i = 0; i <= n; ++i) {
        states.push_back(cyclone_state(cyclone, root, cyclone.length * i / n));
    }
    return states;
}

ConstantHelicity constant_helicity(const Cyclone& cyclone,
                                   const HelixState<double>& root) {
    require_radius(cyclone);
    return {root, cyclone.helicity,
            [cyclone](double s) { return cyclone_turn(cyclone, s); }, cyclone.length};
}

}  // namespace lancret
