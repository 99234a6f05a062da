// Weights along paths of roots: as only distances change, and as partings, limits and
// facing have an effect. A Lipschitz-continuous weight changes by at most L h in a step
// of h.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "procedural/bind/partings.h"
#include "procedural/groom/ready_groom.h"
#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::standing_guides;
using test::StandingGuides;

/// A position and a normal.
struct PathPoint {
    Vec3 position, normal = Vec3::UnitZ();
};
using Path = std::function<PathPoint(double)>;  ///< of t in [0, 1]

/// The largest change of any guide's weight in one step of a path, and its t.
struct Jump {
    double size = 0, t = 0;
};

/// Guides, and settings to bind children on a path.
struct PathBinder {
    const Guides& guides;
    const std::vector<Vec3f>& normals;
    BindSettings settings;
    const Partings* partings = nullptr;
    std::size_t limited = 0;  ///< children on the last path that needed a fallback

    Jump largest_jump(const Path& path, int steps) {
        Roots roots;
        for (int i = 0; i <= steps; ++i) {
            const PathPoint p = path(double(i) / steps);
            roots.positions.push_back(p.position.cast<float>());
            roots.normals.push_back(p.normal.cast<float>());
        }
        const BindBorders borders{
            .guide_regions = {}, .child_regions = {}, .partings = partings};
        const Binding binding = lancret::bind(roots, guides, normals, settings, borders);
        limited = binding.report.no_guide_in_reach + binding.report.no_guide_in_sight;
        Jump worst;
        const std::size_t k = std::size_t(binding.neighbours);
        std::vector<double> change(guides.size(), 0);
        for (std::size_t i = 1; i < binding.size(); ++i) {
            const auto add = [&](std::size_t child, double sign) {
                for (std::size_t j = child * k; j < (child + 1) * k; ++j) {
                    change[binding.guides[j]] += sign * double(binding.weights[j]);
                }
            };
            add(i, 1);
            add(i - 1, -1);
            for (std::size_t j = (i - 1) * k; j < (i + 1) * k; ++j) {
                double& d = change[binding.guides[j]];
                if (std::abs(d) > worst.size) worst = {std::abs(d), double(i) / steps};
                d = 0;
            }
        }
        return worst;
    }

    /// A sixteenth of the step gives a sixteenth of the largest change; a twelfth is
    /// allowed, as a coarse step may cover the steepest part only partially.
    void expect_continuous(const Path& path, const char* what, int steps = 500) {
        const Jump coarse = largest_jump(path, 16 * steps);
        const Jump fine = largest_jump(path, 256 * steps);
        EXPECT_EQ(limited, 0u) << what;
        EXPECT_GT(coarse.size, 0) << what;
        EXPECT_LT(fine.size, coarse.size / 12)
            << what << ": worst at " << fine.t << ", " << fine.size << " after "
            << coarse.size << " at " << coarse.t;
    }
};

Path straight(const Vec3& from, const Vec3& to) {
    return [=](double t) { return PathPoint{from + t * (to - from)}; };
}

/// Around `centre`, from one angle about +Z to another.
Path arc(const Vec3& centre, double radius, double from, double to) {
    return [=](double t) {
        const double angle = from + t * (to - from);
        return PathPoint{centre + radius * Vec3(std::cos(angle), std::sin(angle), 0)};
    };
}

TEST(BindingContinuity, AlongStraightPathsAmongGuides) {
    const StandingGuides standing = standing_guides(150, 1, 31);
    for (const int k : {2, 3, 4, 8}) {
        PathBinder binder{standing.guides, standing.normals, {.neighbours = k}};
        binder.expect_continuous(straight({1, 1.3, 0}, {9, 7.1, 0}), "up");
        binder.expect_continuous(straight({1, 8.7, 0}, {9, 2.4, 0}), "down");
    }
}

TEST(BindingContinuity, AroundTheEndOfAParting) {
    const StandingGuides standing = standing_guides(150, 1, 31);
    const Polyline line{{5, 0, 0}, {5, 5, 0}};
    const Partings partings({&line, 1});
    PathBinder binder{standing.guides, standing.normals, {}, &partings};
    // From 0.25 radian right of the parting to 0.25 radian left of it.
    const double down = -kPi / 2;
    for (const double radius : {0.5, 1.0, 2.0}) {
        binder.expect_continuous(
            arc({5, 5, 0}, radius, down + 0.25, down + 2 * kPi - 0.25), "around the end");
    }
    binder.expect_continuous(straight({5.3, 1, 0}, {5.3, 9, 0}), "beside it");
    // Across the parting itself the weights jump for any step.
    const double through =
        binder.largest_jump(straight({4, 2.2, 0}, {6, 2.3, 0}), 64000).size;
    EXPECT_GT(through, 0.1);
}

TEST(BindingContinuity, AroundTheBendsOfAParting) {
    const StandingGuides standing = standing_guides(150, 1, 33);
    const Polyline zigzag{{5, 0, 0}, {5.6, 2, 0}, {4.6, 4, 0}, {5.8, 6, 0}, {5, 10, 0}};
    const Partings partings({&zigzag, 1});
    PathBinder binder{standing.guides, standing.normals, {}, &partings};
    binder.expect_continuous(straight({6.2, 0.5, 0}, {6.2, 9.5, 0}), "right of it");
    binder.expect_continuous(straight({4.2, 0.5, 0}, {4.2, 9.5, 0}), "left of it");
}

TEST(BindingContinuity, UpToTheMaximumDistance) {
    const StandingGuides standing = standing_guides(400, 1, 35);
    // Small enough that guides come and go, large enough that one is always within it.
    PathBinder binder{standing.guides, standing.normals, {.max_distance = 0.9}};
    binder.expect_continuous(straight({1, 1.3, 0}, {9, 7.1, 0}), "near");
}

TEST(BindingContinuity, UpToTheMaximumAngle) {
    StandingGuides standing = standing_guides(300, 1, 37);
    std::mt19937 random(38);
    std::normal_distribution<float> lean(0, 0.4f);
    for (Vec3f& n : standing.normals) {
        const float x = lean(random), y = lean(random);
        n = Vec3f(x, y, 1).normalized();
    }
    PathBinder binder{standing.guides, standing.normals, {.max_angle = 0.9}};
    binder.expect_continuous(
        [](double t) {
            return PathPoint{
                Vec3(1, 2, 0) + 8 * t * Vec3(1, 0.6, 0),
                Vec3(0.4 * std::sin(9 * t), 0.4 * std::cos(7 * t), 1).normalized()};
        },
        "leaning");
}

TEST(BindingContinuity, AsGuidesTurnAway) {
    const StandingGuides standing = standing_guides(150, 1, 39);
    PathBinder binder{standing.guides, standing.normals, {}};
    // The child's normal makes a full turn: all guides face it, some, none.
    binder.expect_continuous(
        [](double t) {
            return PathPoint{Vec3(2, 2, 0) + 6 * t * Vec3(1, 0.7, 0),
                             Vec3(std::sin(2 * kPi * t), 0, std::cos(2 * kPi * t))};
        },
        "turning", 2000);
}

TEST(BindingContinuity, OnTheMadeHeadAroundItsParting) {
    GroomSettings groom;
    groom.guides.number = 150;
    groom.made.strands = 150;
    groom.fit.segments = 4;
    groom.strands = 1;
    groom.intervals = 4;
    const ReadyGroom made = make_ready_groom(groom);
    ASSERT_EQ(made.placed.partings.size(), 1u);
    const Partings partings(made.placed.partings);
    PathBinder binder{made.placed.guides, made.placed.normals, {}, &partings};
    const auto on_head = [](const Vec3& direction) {
        const Vec3 unit = direction.normalized();
        return PathPoint{unit.cwiseProduct(kMadeHead),
                         unit.cwiseQuotient(kMadeHead).normalized()};
    };
    binder.expect_continuous(
        [&](double t) {
            return on_head({0.08, 1, 0.9 - 1.5 * t});
        },
        "beside the parting");
    binder.expect_continuous(
        [&](double t) {
            const double angle = kPi * (t - 0.5);
            return on_head({0.3 * std::sin(angle), 1, -0.16 - 0.3 * std::cos(angle)});
        },
        "around its end");
}

TEST(BindingContinuity, BetweenTheRootsOfARealGroom) {
    const std::filesystem::path data = LANCRET_SOURCE_DIR "/../shared/data";
    if (!std::filesystem::exists(data / "sintel.hair")) {
        GTEST_SKIP() << "no real grooms in " << data;
    }
    GroomSettings groom;
    groom.name = "sintel";
    groom.strands_file = data / "sintel.hair";
    groom.scalp_file = data / "sintel_head.obj";
    groom.guides.number = 200;
    groom.fit.segments = 3;
    groom.strands = 100;
    groom.intervals = 3;
    const ReadyGroom sintel = make_ready_groom(groom);
    PathBinder binder{sintel.placed.guides, sintel.placed.normals, groom.bind};
    const auto& roots = sintel.binding.roots;
    for (std::size_t i = 0; i + 1 < 12; ++i) {
        // A straight line from child to child, with interpolated normals.
        binder.expect_continuous(
            [&](double t) {
                const auto between = [&](const Vec3f& a, const Vec3f& b) -> Vec3 {
                    return (1 - t) * a.cast<double>() + t * b.cast<double>();
                };
                return PathPoint{
                    between(roots.positions[i], roots.positions[i + 1]),
                    between(roots.normals[i], roots.normals[i + 1]).normalized()};
            },
            "from child to child", 400);
    }
}

}  // namespace
}  // namespace lancret
