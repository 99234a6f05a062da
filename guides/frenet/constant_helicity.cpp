#include "guides/frenet/constant_helicity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace lancret {

namespace {

/// The integral of the tangent from s = a to b, in the root frame.
Vec3 tangent_integral(const ConstantHelicity& strand, double a, double b) {
    static constexpr std::array<double, 5> kNodes{-0.9061798459386640,
                                                  -0.5384693101056831, 0,
                                                  0.5384693101056831, 0.9061798459386640};
    static constexpr std::array<double, 5> kWeights{
        0.2369268850561891, 0.4786286704993665, 128.0 / 225, 0.4786286704993665,
        0.2369268850561891};
    // The error of 5-point Gauss is 4e-13 h^11 f^(10) per part: 2e-16 at a turn of 1/2.
    const double turn =
        std::abs(strand.turn(b) - strand.turn(a)) * std::hypot(1, strand.helicity);
    const int parts = std::max(4, int(std::ceil(std::min(2 * turn, 1e6))));
    const double size = (b - a) / parts;
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < parts; ++i) {
        for (int j = 0; j < 5; ++j) {
            const double s = a + size * (i + 0.5 * (1 + kNodes[j]));
            sum += kWeights[j] *
                   constant_helicity_rotation(strand.helicity, strand.turn(s)).col(0);
        }
    }
    return sum * size / 2;
}

void require_intervals(int n) {
    if (n < 1) {
        throw std::invalid_argument("constant helicity: expected at least one interval");
    }
}

}  // namespace

Mat3 constant_helicity_rotation(double helicity, double q) {
    return helix_step<double>(Vec3(helicity, 0, 1), q).rotation;
}

Vec3 lancret_axis(const Mat3& frame, double helicity) {
    return (helicity * frame.col(0) + frame.col(2)) / std::hypot(1, helicity);
}

std::vector<HelixState<double>> constant_helicity_strand(const ConstantHelicity& strand,
                                                         int n) {
    require_intervals(n);
    std::vector<HelixState<double>> states{strand.root};
    Vec3 moved = Vec3::Zero();  // in the root frame
    for (int i = 1; i <= n; ++i) {
        const double from = strand.length * (i - 1) / n, to = strand.length * i / n;
        moved += tangent_integral(strand, from, to);
        const Mat3 turned = constant_helicity_rotation(strand.helicity, strand.turn(to));
        states.push_back({strand.root.frame * turned,
                          strand.root.position + strand.root.frame * moved});
    }
    return states;
}

FrenetProfile constant_helicity_profile(const ConstantHelicity& strand, int n) {
    require_intervals(n);
    FrenetProfile profile{strand.root, {}, {}};
    for (int i = 0; i < n; ++i) {
        const double from = strand.length * i / n, to = strand.length * (i + 1) / n;
        const double kappa = (strand.turn(to) - strand.turn(from)) / (to - from);
        profile.steps.push_back(to - from);
        profile.rates.push_back({kappa, strand.helicity * kappa});
    }
    return profile;
}

}  // namespace lancret
