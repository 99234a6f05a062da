#include "sim/segment/loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "guides/helix/helix.h"
#include "sim/segment/gauss_legendre.h"
#include "sim/segment/stumpff.h"

namespace lancret {
namespace {

TEST(SegmentLoops, WideRegistersGiveTheSameBits) {
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this machine has no AVX2";
#endif
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto fill = [&](auto&... arrays) {
        const auto one = [&](auto& array) {
            for (double& x : array) x = uniform(random);
        };
        (one(arrays), ...);
    };
    for (const int points : {8, 12, 32}) {
        double k[3], frame[9], start[3], targets[3][32], motion[4][3];
        fill(k, frame, start, targets[0], targets[1], targets[2]);
        fill(motion[0], motion[1], motion[2], motion[3]);
        Mat3::Map(frame) = helix_step<double>(Vec3::Map(k), 3).rotation;
        const GaussRule rule = gauss_rule(points);
        const SegmentLoop loop{k,
                               frame,
                               start,
                               double(points),
                               points,
                               stumpff_halvings(3.0 * points * points),
                               rule.nodes.data(),
                               rule.weights.data(),
                               {targets[0], targets[1], targets[2]}};
        RateVectors rates;
        fill(rates.turn, rates.turn_rate, rates.square, rates.square_rate, rates.rates);
        rates.along = uniform(random);
        rates.speed = uniform(random);
        const StartMotion from{motion[0], motion[1], motion[2], motion[3]};
        struct Results {
            double sums[kSegmentSums], positions[96], velocities[96], bias[96];
            void of(const SegmentLoops& loops, const SegmentLoop& at,
                    const RateVectors& r, const StartMotion& m) {
                loops.sums(at, sums);
                loops.positions(at, r, positions, 32);
                loops.velocities(at, r, m, velocities, 32);
                loops.bias(at, r, m, bias, 32);
            }
        };
        // A chain of such segments; its inertia is positive definite, as required.
        const auto solution = [&](const SegmentLoops& loops) {
            std::vector<SegmentBlock> rod(5);
            std::vector<double> x(15), diagonal(15, 2.), load(15, 0.1);
            double sums[kSegmentSums + 1] = {};
            loops.sums(loop, sums);
            for (SegmentBlock& s : rod) {
                s = {};
                std::copy_n(frame, 9, s.frame);
                std::copy_n(motion[0], 3, s.offset);
                std::copy_n(frame, 9, s.turn);
                loops.to_space(sums, 0.3, s);
            }
            loops.solve(rod.data(), 5, diagonal.data(), load.data(), x.data());
            return x;
        };
        const auto one = solution(kPlainLoops);
        EXPECT_TRUE(std::isfinite(one[0]));
        EXPECT_EQ(one, solution(kWideLoops));
        Results plain{}, wide{};
        plain.of(kPlainLoops, loop, rates, from);
        wide.of(kWideLoops, loop, rates, from);
        EXPECT_EQ(std::memcmp(&plain, &wide, sizeof(Results)), 0) << points;
    }
}

}  // namespace
}  // namespace lancret
