#include "guides/mesh/scalp_roots.h"

#include <gmock/gmock.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "tests/guides/base/temporary_folder.h"
#include "tests/guides/mesh/meshes.h"

namespace lancret {
namespace {

bool same(const MeshPoint& a, const MeshPoint& b) {
    return a.triangle == b.triangle && a.u == b.u && a.v == b.v;
}

void expect_same(std::span<const MeshPoint> a, std::span<const MeshPoint> b) {
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end(), same));
}

bool in_cap(const MeshPoint&, const Vec3& p) { return p.y() > 0.5; }

std::vector<Vec2> places_in_square(std::uint32_t cells, std::size_t count,
                                   std::uint64_t seed) {
    const Scalp scalp = make_scalp(square_mesh(1, cells));
    std::vector<Vec2> places;
    for (const MeshPoint& root : scalp_roots(scalp, count, seed)) {
        places.push_back(scalp_position(scalp, root).head<2>());
    }
    return places;
}

/// A lower limit of the star discrepancy: the largest of |share in [0, x) x [0, y) - x y|
/// over a grid of corners.
double discrepancy(const std::vector<Vec2>& places) {
    const int cells = 64;
    Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(cells + 1, cells + 1);
    for (const Vec2& p : places) {
        counts(std::min(int(p.x() * cells), cells - 1) + 1,
               std::min(int(p.y() * cells), cells - 1) + 1) += 1;
    }
    double worst = 0;
    for (int i = 1; i <= cells; ++i) {
        for (int j = 1; j <= cells; ++j) {
            counts(i, j) += counts(i - 1, j) + counts(i, j - 1) - counts(i - 1, j - 1);
            const double area = double(i) / cells * j / cells;
            worst =
                std::max(worst, std::abs(counts(i, j) / double(places.size()) - area));
        }
    }
    return worst;
}

TEST(ScalpRoots, RootDoesNotDependOnTheCount) {
    const Scalp scalp = make_scalp(sphere_mesh(16));
    const auto many = scalp_roots(scalp, 20000, 7);
    const auto few = scalp_roots(scalp, 333, 7);
    expect_same(few, std::span(many).first(333));
    const auto many_caps = scalp_roots(scalp, 20000, 7, in_cap);
    const auto few_caps = scalp_roots(scalp, 333, 7, in_cap);
    expect_same(few_caps, std::span(many_caps).first(333));
    EXPECT_TRUE(scalp_roots(scalp, 0, 7, in_cap).empty());
}

TEST(ScalpRoots, RootIsTheAcceptedCandidateOfItsNumber) {
    const Scalp scalp = make_scalp(sphere_mesh(16));
    std::vector<MeshPoint> expected;
    for (const MeshPoint& point : scalp_roots(scalp, 20000, 7)) {
        if (in_cap(point, scalp_position(scalp, point))) expected.push_back(point);
    }
    expect_same(scalp_roots(scalp, expected.size(), 7, in_cap), expected);
}

TEST(ScalpRoots, SameForAnyNumberOfThreads) {
    const Scalp scalp = make_scalp(sphere_mesh(16));
    const auto by_many = scalp_roots(scalp, 50000, 3, in_cap);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    expect_same(scalp_roots(scalp, 50000, 3, in_cap), by_many);
}

TEST(ScalpRoots, SameBitsOnEveryMachine) {
    // Fixed bits: the start of the sequence on one square of two triangles.
    const auto roots = scalp_roots(make_scalp(square_mesh(1, 1)), 3, 0);
    // Computed with Python's integers from the recurrence in the header.
    const MeshPoint expected[] = {{1, 0x1.93087e0000000p-2f, 0x1.bcf2720000000p-2f},
                                  {1, 0x1.300e480000000p-3f, 0x1.fef0080000000p-3f},
                                  {0, 0x1.9d05ca0000000p-2f, 0x1.20fecc0000000p-1f}};
    expect_same(roots, expected);
}

TEST(ScalpRoots, SeedsGiveOtherRoots) {
    const Scalp scalp = make_scalp(square_mesh(1, 4));
    const auto a = scalp_roots(scalp, 100, 1), b = scalp_roots(scalp, 100, 2);
    int alike = 0;
    for (std::size_t i = 0; i < 100; ++i) alike += same(a[i], b[i]);
    EXPECT_EQ(alike, 0);
}

TEST(ScalpRoots, SharesAreProportionalToArea) {
    // Groups of triangles that are neighbours on the mesh, of very different areas (the
    // sphere's triangles shrink towards the poles).
    const Scalp scalp = make_scalp(sphere_mesh(32));
    const std::size_t count = 100000, group = 64;
    std::vector<double> share(scalp.areas.size() / group), area(share.size());
    for (const MeshPoint& root : scalp_roots(scalp, count, 11)) {
        share[root.triangle / group] += 1.0 / double(count);
    }
    for (std::size_t i = 0; i < scalp.areas.size(); ++i) {
        area[i / group] += scalp.areas[i] / scalp.area;
    }
    for (std::size_t g = 0; g < share.size(); ++g) {
        // Independent places would have a standard deviation of sqrt(a (1 - a) / n).
        // These are more even: no group may exceed two of it, although 64 * 4.6 % = 3
        // would if the places were independent.
        EXPECT_NEAR(share[g], area[g], 2 * std::sqrt(area[g] * (1 - area[g]) / count))
            << g;
    }
}

TEST(ScalpRoots, MoreEvenThanRandom) {
    // Independent places have a star discrepancy near 0.8 / sqrt(n); one random set in a
    // thousand falls below half of that. The sequence should stay below a third of
    // random, on a surface of two triangles and on one of many.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform;
    for (const int count : {1000, 10000}) {
        std::vector<Vec2> places(std::size_t(count), Vec2::Zero());
        for (Vec2& p : places) p = {uniform(random), uniform(random)};
        const double of_random = discrepancy(places);
        for (const std::uint32_t cells : {1u, 8u, 100u}) {
            for (const std::uint64_t seed : {1, 2, 3}) {
                const double d =
                    discrepancy(places_in_square(cells, std::size_t(count), seed));
                EXPECT_LT(d, of_random / (count == 1000 ? 2 : 3))
                    << cells << " cells, " << count << " roots";
            }
        }
    }
}

TEST(ScalpRoots, FillsATriangleEvenly) {
    // Four subtriangles of equal area, by the midpoints of the edges.
    const Scalp scalp = make_scalp(square_mesh(1, 1));
    const int count = 40000;
    int quarter[4] = {};
    for (const MeshPoint& root : scalp_roots(scalp, count, 13)) {
        EXPECT_LE(root.u + root.v, 1);
        ++quarter[root.u > 0.5f ? 1 : root.v > 0.5f ? 2 : root.u + root.v < 0.5f ? 3 : 0];
    }
    // Independent: a standard deviation of sqrt(3 / 16 / n) = 0.0022.
    for (const int q : quarter) EXPECT_NEAR(double(q) / count, 0.25, 0.0022);
}

TEST(ScalpRoots, TrianglesWithoutAreaGetNoRoots) {
    const Scalp scalp = make_scalp(sphere_mesh(8));
    for (const MeshPoint& root : scalp_roots(scalp, 10000, 1)) {
        EXPECT_GT(scalp.areas[root.triangle], 0);
    }
}

TEST(ScalpRoots, ScalpWithoutAreaIsAnInputError) {
    TriangleMesh mesh = square_mesh(1, 1);
    mesh.triangles = {{0, 0, 0}, {0, 1, 1}};
    mesh.uvs.clear();
    EXPECT_THAT(input_error([&] { scalp_roots(make_scalp(mesh), 1, 0); }),
                testing::HasSubstr("the scalp has no area"));
}

TEST(ScalpRoots, HopelessFilterIsAnInputError) {
    const Scalp scalp = make_scalp(square_mesh(1, 1));
    const auto none = [](const MeshPoint&, const Vec3&) { return false; };
    EXPECT_THAT(input_error([&] { scalp_roots(scalp, 10, 0, none); }),
                testing::HasSubstr("hair may grow at only 0 of 131072 places"));
    // One in 400 is few, but enough.
    const auto few = [](const MeshPoint&, const Vec3& p) {
        return p.x() < 0.05 && p.y() < 0.05;
    };
    EXPECT_EQ(scalp_roots(scalp, 2000, 0, few).size(), 2000u);
}

}  // namespace
}  // namespace lancret
