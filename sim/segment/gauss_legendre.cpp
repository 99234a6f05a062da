#include "sim/segment/gauss_legendre.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

namespace {

struct Table {
    std::array<std::vector<double>, kMaxGaussPoints + 1> nodes, weights;

    Table() {
        for (int n = 1; n <= kMaxGaussPoints; ++n) make(n);
    }

    /// Finds the roots of the Legendre polynomial P_n by Newton's method. They lie in
    /// pairs about the middle.
    void make(int n) {
        nodes[n].resize(n);
        weights[n].resize(n);
        for (int i = 0; i < (n + 1) / 2; ++i) {
            double x = std::cos(kPi * (i + 0.75) / (n + 0.5)), slope = 0;
            for (int round = 0; round < 8; ++round) {
                double before = 0, value = 1;
                for (int d = 0; d < n; ++d) {
                    const double next = ((2 * d + 1) * x * value - d * before) / (d + 1);
                    before = std::exchange(value, next);
                }
                slope = n * (x * value - before) / (x * x - 1);
                x -= value / slope;
            }
            const double weight = 1 / ((1 - x * x) * slope * slope);
            nodes[n][i] = (1 - x) / 2;
            nodes[n][n - 1 - i] = (1 + x) / 2;
            weights[n][i] = weights[n][n - 1 - i] = weight;
        }
    }
};

}  // namespace

GaussRule gauss_rule(int n) {
    static const Table table;
    assert(n >= 1 && n <= kMaxGaussPoints);
    return {table.nodes[n], table.weights[n]};
}

int gauss_points(double turn) {
    // Compared before rounding, since a turn may exceed the range of int.
    if (!(turn < kMaxGaussPoints - 5)) return kMaxGaussPoints;
    const int points = 5 + int(std::ceil(turn));
    return std::clamp((points + 3) / 4 * 4, 8, kMaxGaussPoints);
}

}  // namespace lancret
