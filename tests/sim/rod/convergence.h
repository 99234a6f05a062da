#pragma once
// Asserts second-order convergence.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

namespace lancret {

/// Computes a vector value(N) with N, 2N and 4N segments, N = `coarsest`, prints the
/// norms of its errors, and expects
///  - that doubling N divides the changes by 4: the observed order is 2 within 0.15,
///  which
///    allows for the next term, h^4 (a segment may turn by 0.6 rad);
///  - that the Romberg extrapolation, free of h^2 and h^4, is within `limit` of the
///    reference.
/// The order is not tested for changes below 1e-8: equilibria are solved to 1e-9.
inline void expect_second_order(const char* what, const Eigen::VectorXd& reference,
                                double limit,
                                const std::function<Eigen::VectorXd(int)>& value,
                                int coarsest = 20) {
    std::array<Eigen::VectorXd, 3> v;
    for (int i = 0; i < 3; ++i) v[i] = value(coarsest << i);
    const Eigen::VectorXd once = (4 * v[1] - v[0]) / 3, again = (4 * v[2] - v[1]) / 3;
    const Eigen::VectorXd twice = (16 * again - once) / 15;
    const double order = std::log2((v[0] - v[1]).norm() / (v[1] - v[2]).norm());
    fmt::print("{:<32} N {:>2}: {:.2e} {:.2e} {:.2e}  order {:.3f}  limit {:.1e} off\n",
               what, coarsest, (v[0] - reference).norm(), (v[1] - reference).norm(),
               (v[2] - reference).norm(), order, (twice - reference).norm());
    EXPECT_LT((twice - reference).norm(), limit) << what;
    if ((v[0] - v[1]).norm() < 1e-8) return;
    EXPECT_NEAR(order, 2, 0.15) << what;
}

inline void expect_second_order(const char* what, double reference, double limit,
                                const std::function<double(int)>& value,
                                int coarsest = 20) {
    const auto one = [](double x) { return Eigen::VectorXd::Constant(1, x); };
    expect_second_order(
        what, one(reference), limit,
        [&](int segments) -> Eigen::VectorXd { return one(value(segments)); }, coarsest);
}

}  // namespace lancret
