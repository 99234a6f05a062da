#pragma once
// Dense strands for tests of the evaluation.

#include <cmath>
#include <random>

#include "guides/strand/strands.h"

namespace lancret::test {

/// `count` random strands of 5 to 15 cm from [0, 10]^2 at z = 0, which lean by up to 0.3
/// of their length and wind `turns` times with a radius of 0.3 cm and a random phase.
inline Strands curly_strands(int count, unsigned seed, double turns = 2) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0, 10), length(5, 15), lean(-0.3, 0.3),
        phase(0, 6.283);
    Strands out;
    for (int i = 0; i < count; ++i) {
        const double x = place(random), y = place(random), tall = length(random);
        const double a = lean(random), b = lean(random), start = phase(random);
        constexpr int kPoints = 160;
        for (int j = 0; j < kPoints; ++j) {
            const double t = double(j) / (kPoints - 1), angle = 6.283 * turns * t + start;
            const double r = turns > 0 ? 0.3 * std::min(1.0, 5 * t) : 0;
            out.points.push_back(Vec3(x + a * tall * t * t + r * std::cos(angle),
                                      y + b * tall * t * t + r * std::sin(angle),
                                      tall * t)
                                     .cast<float>());
        }
        out.first.push_back(std::uint32_t(out.points.size()));
    }
    return out;
}

}  // namespace lancret::test
