#include "guides/made/made_groom.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "guides/mesh/closest_point.h"
#include "guides/mesh/scalp.h"

namespace lancret {
namespace {

/// Above 1 outside the head, 1 on it.
double head_level(const Vec3f& p) {
    return p.cast<double>().cwiseQuotient(kMadeHead).norm();
}

double length_of(std::span<const Vec3f> strand) {
    double length = 0;
    for (std::size_t i = 1; i < strand.size(); ++i) {
        length += (strand[i] - strand[i - 1]).cast<double>().norm();
    }
    return length;
}

/// The mean distance of corresponding points, with the roots moved together.
double unlikeness(std::span<const Vec3f> a, std::span<const Vec3f> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += ((a[i] - a[0]) - (b[i] - b[0])).norm();
    }
    return sum / double(a.size());
}

TEST(MadeGroom, NoHairInsideTheHead) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        MadeGroomSettings settings;
        settings.seed = seed;
        settings.strands = 2000;
        settings.curl_radius = 0.2 * double(seed * seed);
        const MadeGroom groom = make_groom(settings);
        for (std::size_t s = 0; s < groom.strands.size(); ++s) {
            const auto strand = groom.strands.strand(s);
            // The root is on a facet: 0.82 cm wide, its middle 0.82^2 / 8 / 7.5 = 0.011
            // cm below the ellipsoid along each of two directions.
            EXPECT_NEAR(head_level(strand[0]), 1, 2 * 0.011 / 7.5);
            for (std::size_t i = 1; i < strand.size(); ++i) {
                ASSERT_GT(head_level(strand[i]), 1) << "strand " << s << ", point " << i;
            }
        }
    }
}

TEST(MadeGroom, LengthsAreThoseOfTheSettings) {
    const MadeGroom groom = make_groom({});
    double shortest = 1e9, longest = 0;
    for (std::size_t s = 0; s < groom.strands.size(); ++s) {
        const auto strand = groom.strands.strand(s);
        ASSERT_EQ(strand.size(), 64u);
        const double length = length_of(strand);
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
        // Points of up to 32 cm are rounded by 2^-20 cm per axis: 3.3e-6 cm per segment.
        for (std::size_t i = 1; i < strand.size(); ++i) {
            EXPECT_NEAR((strand[i] - strand[i - 1]).cast<double>().norm(), length / 63,
                        2 * 3.3e-6);
        }
    }
    EXPECT_GE(shortest, 25 - 64 * 3.3e-6);
    EXPECT_LE(longest, 35 + 64 * 3.3e-6);
    EXPECT_GT(longest - shortest, 5);
}

TEST(MadeGroom, SameSeedSameBitsForAnyThreadsAndCount) {
    MadeGroomSettings settings;
    const MadeGroom a = make_groom(settings);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    settings.strands = 100;
    const MadeGroom b = make_groom(settings);
    EXPECT_TRUE(std::equal(b.strands.points.begin(), b.strands.points.end(),
                           a.strands.points.begin()));
    settings.seed = 2;
    EXPECT_NE(make_groom(settings).strands.points, b.strands.points);
}

TEST(MadeGroom, NeighboursLookAlike) {
    MadeGroomSettings settings;
    settings.strands = 2000;
    const Strands strands = make_groom(settings).strands;
    double of_neighbours = 0, of_any = 0;
    for (std::size_t a = 0; a < strands.size(); ++a) {
        // Strands differ across the parting.
        std::size_t nearest = a;
        float least = std::numeric_limits<float>::max();
        for (std::size_t b = 0; b < strands.size(); ++b) {
            const float d = (strands.strand(a)[0] - strands.strand(b)[0]).norm();
            if (b == a || d >= least ||
                strands.strand(a)[0].x() * strands.strand(b)[0].x() < 0) {
                continue;
            }
            least = d;
            nearest = b;
        }
        of_neighbours += unlikeness(strands.strand(a), strands.strand(nearest));
        of_any += unlikeness(strands.strand(a),
                             strands.strand((a + strands.size() / 2) % strands.size()));
    }
    EXPECT_LT(of_neighbours, of_any / 4);
}

TEST(MadeGroom, CurlRadiusMakesTheCurl) {
    // Without waves and frizz a strand is smooth: the turn from segment to segment falls.
    const auto bending = [](double radius) {
        MadeGroomSettings settings;
        settings.curl_radius = radius;
        settings.frizz = 0;
        const Strands strands = make_groom(settings).strands;
        double sum = 0;
        for (std::size_t s = 0; s < strands.size(); ++s) {
            const auto p = strands.strand(s);
            // Its last third hangs free.
            for (std::size_t i = 44; i + 2 < p.size(); ++i) {
                const Vec3f a = (p[i + 1] - p[i]).normalized();
                sum += (a - (p[i + 2] - p[i + 1]).normalized()).norm();
            }
        }
        return sum;
    };
    EXPECT_GT(bending(0.35), 5 * bending(0));
    EXPECT_GT(bending(0.7), 1.5 * bending(0.35));
}

TEST(MadeGroom, ScalpIsThePartOfTheHeadWithinTheHairline) {
    const MadeGroom groom = make_groom({});
    const Scalp head = make_scalp(groom.head), scalp = make_scalp(groom.scalp);
    // Thomsen's formula for the area of an ellipsoid is accurate to 1.1 %; facets of 5
    // degrees lose 0.2 %.
    const double p = 1.6075, ab = std::pow(7.5 * 11, p), ac = std::pow(7.5 * 9.5, p),
                 bc = std::pow(11 * 9.5, p);
    const double area = 4 * 3.14159265 * std::pow((ab + ac + bc) / 3, 1 / p);
    EXPECT_NEAR(head.area / area, 1, 0.013);
    EXPECT_GT(scalp.area, 0.4 * head.area);
    EXPECT_LT(scalp.area, 0.7 * head.area);
    EXPECT_EQ(scalp.mesh.uvs.size(), scalp.mesh.triangles.size());
    for (std::uint32_t i = 0; i < head.areas.size(); ++i) {
        EXPECT_GT(head.areas[i], 0);
        const MeshPoint middle{i, 1.0f / 3, 1.0f / 3};
        EXPECT_GT(scalp_normal(head, middle).dot(scalp_position(head, middle)), 0);
    }
    for (const Vec3f& v : groom.scalp.positions) {
        // None on the face: in front, below the forehead.
        EXPECT_FALSE(v.z() > 7 && v.y() < 4) << v.transpose();
    }
    const ClosestPoint closest(groom.scalp);
    for (std::size_t s = 0; s < groom.strands.size(); ++s) {
        const Vec3 root = groom.strands.strand(s)[0].cast<double>();
        EXPECT_LT(closest.closest(root).distance, 2e-6);
    }
}

TEST(MadeGroom, RejectsSettingsOutOfRange) {
    const auto rejects = [](auto change) {
        MadeGroomSettings settings;
        change(settings);
        EXPECT_THROW(make_groom(settings), std::invalid_argument);
    };
    rejects([](auto& s) { s.strands = 0; });
    rejects([](auto& s) { s.points = 3; });
    rejects([](auto& s) { s.shortest = 0; });
    rejects([](auto& s) { s.longest = 24; });
    rejects([](auto& s) { s.curl_radius = -1; });
    rejects([](auto& s) { s.curl_wavelength = std::nan(""); });
    rejects([](auto& s) { s.frizz = 1e9; });
}

}  // namespace
}  // namespace lancret
