// The faces of ribbons over time.

#include "procedural/expand/faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "procedural/groom/ready_groom.h"
#include "tests/procedural/made_hair.h"
#include "tests/procedural/small_groom.h"

namespace lancret {
namespace {

using test::standing_guides;
using test::StandingGuides;

constexpr int kIntervals = 12;

/// The guides with all curvatures scaled by `share`: 1 is the rest pose, 0 straight.
GuideProfiles<float> swung(const Guides& rest, double share) {
    Guides guides = rest;
    for (Vec3& u : guides.curvatures) u *= share;
    return guide_profiles<float>(guides, kIntervals);
}

/// Children of the guides `standing`, with the faces of their rest pose.
Binding with_faces(const StandingGuides& standing, int neighbours, Blend blend) {
    Binding out = bind(test::plane_roots(200, 5), standing.guides, standing.normals,
                       {.neighbours = neighbours});
    out.faces = rest_faces(out, swung(standing.guides, 1), blend);
    return out;
}

Curves ribbons(const Binding& binding, const GuideProfiles<float>& profiles,
               Blend blend) {
    // With the scalar blends, which choose the faces.
    Curves out;
    expand(binding, profiles, {}, {.blend = blend, .shape = CurveShape::ribbon}, out);
    return out;
}

std::vector<HelixState<float>> states_of(const Binding& binding,
                                         const GuideProfiles<float>& profiles,
                                         Blend blend, std::size_t i) {
    std::vector<HelixState<float>> out(kIntervals + 1);
    synthesize_child<float>(binding, profiles, blend, i, out);
    return out;
}

TEST(RibbonFaces, StayWhenABendSwingsThroughStraight) {
    // Each guide bends in one plane, and so does a child of one guide: its normal at a
    // place turns by at most the change of the bend up to there.
    StandingGuides standing = standing_guides(30, 4, 3, 0.1);
    double bend = 0;  // the largest of a strand, radians
    for (std::size_t g = 0; g < standing.guides.size(); ++g) {
        const double angle = double(g);
        double sum = 0;
        for (std::size_t q = 4 * g; q < 4 * g + 4; ++q) {
            Vec3& u = standing.guides.curvatures[q];
            const double size = 0.05 + u.norm() / 10;
            u = size * Vec3(0, std::cos(angle), std::sin(angle));
            sum += size * standing.guides.segment_lengths[q];
        }
        bend = std::max(bend, sum);
    }
    constexpr int kSteps = 40;
    // Frames in single precision are accurate to 5e-7; the anchor's tilt divides the
    // rounding errors of two spines by 0.05: 2 * 5e-7 / 0.05 = 2e-5 at either time.
    const double limit = bend * 2 / kSteps + 2 * 2e-5;
    ASSERT_LT(limit, 0.2);
    for (const BlendTraits& entry : blends()) {
        SCOPED_TRACE(entry.name);
        const Binding binding = with_faces(standing, 1, entry.blend);
        Curves before = ribbons(binding, swung(standing.guides, 1), entry.blend);
        double largest = 0;
        for (int step = 1; step <= kSteps; ++step) {
            const double share = 1 - 2.0 * step / kSteps;
            Curves now = ribbons(binding, swung(standing.guides, share), entry.blend);
            for (std::size_t j = 0; j < now.normals.size(); ++j) {
                const std::size_t place = j % now.points_of(0);
                // The outermost control points are not the normal of a place.
                if (place == 0 || place == kIntervals + 2) continue;
                const Vec3f turn = now.normals[j].xyz() - before.normals[j].xyz();
                largest = std::max(largest, double(turn.norm()));
            }
            before = std::move(now);
        }
        EXPECT_LE(largest, limit);
    }
}

TEST(RibbonFaces, OfTwoTimesNeverCancel) {
    // The unit normals of two times differ by at most the rotation of the strand's frame,
    // so the length of their mean is at least the cosine of half of that angle. The
    // guides also twist, and they swing through straight between the two times, so that
    // bent_face of the two poses flips.
    const StandingGuides standing = standing_guides(30, 4, 7);
    for (const BlendTraits& entry : blends()) {
        // Their frames turn with the bend; see the test above.
        if (entry.rates == BlendRates::blended) continue;
        SCOPED_TRACE(entry.name);
        const Binding binding = with_faces(standing, 4, entry.blend);
        const auto opening = swung(standing.guides, 0.08);
        const auto closing = swung(standing.guides, -0.08);
        const Curves from = ribbons(binding, opening, entry.blend);
        const Curves to = ribbons(binding, closing, entry.blend);
        std::size_t compared = 0, flips = 0;
        for (std::size_t i = 0; i < binding.size(); ++i) {
            const auto a = states_of(binding, opening, entry.blend, i);
            const auto b = states_of(binding, closing, entry.blend, i);
            flips += bent_face(a).dot(bent_face(b)) < -0.9f;
            for (std::size_t j = 0; j <= kIntervals; ++j) {
                const Mat3f turn = b[j].frame * a[j].frame.transpose();
                const float cosine = (turn.trace() - 1) / 2;
                if (!(cosine > 0)) continue;
                ++compared;
                const std::size_t k = i * from.points_of(0) + j + 1;
                const Vec3f half = (from.normals[k].xyz() + to.normals[k].xyz()) / 2;
                // Frames are accurate to 5e-7, cos^2(turn / 2) = (1 + cosine) / 2 to
                // three times that.
                EXPECT_GE(half.squaredNorm(), (1 + cosine) / 2 - 2e-6f) << i << ' ' << j;
            }
        }
        EXPECT_GT(compared, binding.size() * kIntervals / 2);
        EXPECT_GT(flips, binding.size() / 2);
    }
}

TEST(RibbonFaces, AtRestAreTheSidesThatStrandsBendTowards) {
    const StandingGuides standing = standing_guides(30, 4, 9);
    const auto rest = swung(standing.guides, 1);
    for (const BlendTraits& entry : blends()) {
        SCOPED_TRACE(entry.name);
        const Binding binding = with_faces(standing, 4, entry.blend);
        const Curves curves = ribbons(binding, rest, entry.blend);
        const bool turned = entry.rates == BlendRates::blended;
        std::vector<Point4f> normals(kIntervals + 3);
        for (std::size_t i = 0; i < binding.size(); ++i) {
            const auto states = states_of(binding, rest, entry.blend, i);
            ribbon_normals(states, bent_face(states), normals);
            const Point4f* out = &curves.normals[i * curves.points_of(0)];
            if (!turned) {
                EXPECT_EQ(
                    std::memcmp(out, normals.data(), normals.size() * sizeof(Point4f)), 0)
                    << i;
                continue;
            }
            // Option 1's angle is rotated and rotated back, with a few roundings of 6e-8;
            // the outermost control point is twice one normal minus the next.
            for (std::size_t j = 0; j < normals.size(); ++j) {
                EXPECT_LT((out[j].xyz() - normals[j].xyz()).norm(), 3e-6f) << i;
            }
        }
    }
}

TEST(RibbonFaces, DoNotMoveStrandsAndAreThoseOfTheScalarBlends) {
    const StandingGuides standing = standing_guides(30, 4, 9);
    const auto rest = swung(standing.guides, 1);
    for (const BlendTraits& entry : blends()) {
        SCOPED_TRACE(entry.name);
        const Binding binding = with_faces(standing, 4, entry.blend);
        const Curves scalar = ribbons(binding, rest, entry.blend);
        const Curves fast =
            expand(binding, rest, {.blend = entry.blend, .shape = CurveShape::ribbon});
        const Curves plain = expand(binding, rest, {.blend = entry.blend});
        ASSERT_EQ(fast.points.size(), plain.points.size());
        EXPECT_EQ(
            std::memcmp(fast.points.data(), plain.points.data(), plain.points.bytes()),
            0);
        ASSERT_EQ(fast.normals.size(), scalar.normals.size());
        // Frames differ by up to 1e-4 radians (of option 1, see
        // tests/procedural/kernels/curl_test.cpp), and so do faces; the outermost control
        // point is twice one normal minus the next.
        for (std::size_t j = 0; j < fast.normals.size(); ++j) {
            EXPECT_LT((fast.normals[j].xyz() - scalar.normals[j].xyz()).norm(), 1e-3f);
        }
    }
}

TEST(RibbonFaces, AreChosenOnlyIfRequested) {
    GroomSettings groom =
        test::small_groom({.made = 60, .guides = 20, .segments = 8, .strands = 50});
    EXPECT_TRUE(make_ready_groom(groom).binding.faces.empty());
    groom.expand.faces = true;
    EXPECT_EQ(make_ready_groom(groom).binding.faces.size(), 50u);
    groom.expand.faces = false;
    groom.expand.shape = CurveShape::ribbon;
    ReadyGroom ready = make_ready_groom(groom);
    EXPECT_EQ(ready.binding.faces.size(), 50u);
    ready.binding.faces.clear();
    EXPECT_THROW(expand(ready.binding, ready.profiles, groom.expand),
                 std::invalid_argument);
}

}  // namespace
}  // namespace lancret
