#include "procedural/chunk/chunks.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>
#include <random>

#include "procedural/check/chunks.h"
#include "procedural/check/strand.h"
#include "procedural/chunk/chunked_groom.h"
#include "procedural/motion/posed_binding.h"
#include "tests/procedural/curve_box.h"
#include "tests/procedural/made_hair.h"
#include "tests/procedural/small_groom.h"

namespace lancret {
namespace {

using test::MadeHair;

std::vector<Vec3f> random_places(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-10, 10);
    std::vector<Vec3f> out;
    for (std::size_t i = 0; i < count; ++i) {
        const float x = place(random), y = place(random), z = place(random);
        out.emplace_back(x, y, z);
    }
    return out;
}

Chunks chunks_of(const std::vector<Vec3f>& roots, std::uint32_t max_strands) {
    return make_chunks(
        roots.size(), [&](std::uint32_t i) { return roots[i]; }, max_strands);
}

TEST(Chunks, HoldEveryChildOnceInOrder) {
    for (const std::size_t count : {1u, 2u, 99u, 100u, 101u, 5000u}) {
        const Chunks chunks = chunks_of(random_places(count, 1), 100);
        EXPECT_EQ(chunks.size(), (count + 99) / 100);
        std::vector<std::uint32_t> all;
        for (std::size_t c = 0; c < chunks.size(); ++c) {
            const auto children = chunks.of(c);
            EXPECT_LE(children.size(), 100u);
            EXPECT_GE(children.size(), count / chunks.size());
            EXPECT_TRUE(std::ranges::is_sorted(children));
            all.insert(all.end(), children.begin(), children.end());
        }
        std::ranges::sort(all);
        std::vector<std::uint32_t> expected(count);
        std::iota(expected.begin(), expected.end(), 0u);
        EXPECT_EQ(all, expected);
    }
}

TEST(Chunks, AreTheSameForAnyNumberOfThreads) {
    // Some children stand at the same place.
    std::vector<Vec3f> roots = random_places(20000, 2);
    std::fill(roots.begin() + 100, roots.begin() + 3000, roots[0]);
    const Chunks expected = chunks_of(roots, 64);
    for (const int threads : {1, 2, 5}) {
        tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    threads);
        const Chunks chunks = chunks_of(roots, 64);
        EXPECT_EQ(chunks.children, expected.children);
        EXPECT_EQ(chunks.first, expected.first);
    }
}

TEST(Chunks, AreCompact) {
    // 64 chunks of a square of side 20 have boxes of side 20 / 8, less the margin of 100
    // uniform roots: together they have almost the area of the square.
    std::vector<Vec3f> roots = random_places(6400, 3);
    for (Vec3f& p : roots) p.z() = 0;
    const Chunks chunks = chunks_of(roots, 100);
    double area = 0;
    for (std::size_t c = 0; c < chunks.size(); ++c) {
        Eigen::AlignedBox3f box;
        for (const std::uint32_t i : chunks.of(c)) box.extend(roots[i]);
        area += double(box.sizes().x()) * double(box.sizes().y());
    }
    EXPECT_LE(area, 400);
    EXPECT_GE(area, 400 * 0.9);
}

TEST(Chunks, OfNoChildrenAreNone) {
    EXPECT_EQ(make_chunks(0, {}).size(), 0u);
    EXPECT_THROW(make_chunks(
                     1, [](auto) { return Vec3f(0, 0, 0); }, 0),
                 std::invalid_argument);
}

GroomSettings groom_to_cut() {
    return test::small_groom({.made = 40, .guides = 12, .segments = 4, .strands = 1000});
}

/// A chunk's strands at rest.
Curves expanded(const ChunkedGroom& groom, std::size_t chunk) {
    return expand(bind_chunk(groom, chunk), rest_guides(groom.ready),
                  groom.ready.groom.expand);
}

void expect_chunks_of_the_whole(const GroomSettings& groom) {
    const ReadyGroom whole = make_ready_groom(groom);
    const Curves all = expand(whole.binding, rest_guides(whole), groom.expand);
    std::map<std::uint32_t, std::uint32_t> place;  // id -> index
    for (std::uint32_t i = 0; i < all.strands; ++i) place[all.id_of(i)] = i;
    for (const std::uint32_t max_strands : {1000u, 128u, 7u}) {
        const ChunkedGroom chunked = make_chunked_groom(groom, max_strands);
        ASSERT_EQ(chunked.ready.profiles.count, whole.profiles.count);
        std::size_t strands = 0;
        for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
            const Curves chunk = expanded(chunked, c);
            strands += chunk.strands;
            for (std::uint32_t i = 0; i < chunk.strands; ++i) {
                const std::uint32_t id = chunk.id_of(i);
                ASSERT_TRUE(place.contains(id));
                const auto mine = chunk.of_strand(chunk.points, i),
                           theirs = all.of_strand(all.points, place[id]);
                ASSERT_EQ(mine.size(), theirs.size());
                ASSERT_EQ(std::memcmp(mine.data(), theirs.data(), mine.size_bytes()), 0)
                    << max_strands << ' ' << id;
            }
        }
        EXPECT_EQ(strands, all.strands);
    }
}

TEST(Chunks, HaveTheBitsOfTheWhole) {
    for (const Blend blend : {Blend::detail, Blend::option1}) {
        GroomSettings groom = groom_to_cut();
        groom.expand.blend = blend;
        expect_chunks_of_the_whole(groom);
    }
}

TEST(Chunks, HaveTheBitsOfTheWholeAtAnyDensity) {
    GroomSettings groom = groom_to_cut();
    groom.density = 0.2;
    expect_chunks_of_the_whole(groom);
}

TEST(ChunkBox, HoldsItsStrandsTightly) {
    for (const BlendTraits& named : blends()) {
        for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
            const MadeHair hair(600, 24, 7, 4, 4, 0.5);
            const ExpandSettings settings{
                .blend = named.blend, .basis = basis, .taper = {0.05f, 0.01f}};
            const Curves curves = expand(hair.binding, hair.profiles, settings);
            const Chunks chunks = chunks_of(hair.binding.roots.positions, 100);
            const ChunkCheck check = check_chunks(
                hair.binding, hair.classed(settings.blend), curves, settings, chunks);
            EXPECT_EQ(check.chunks, 6u);
            EXPECT_TRUE(check.pass()) << named.name << ' ' << chunks_line(check);
            // The boxes have sides of about 10 cm. The hulls of segments that turn by up
            // to a third of a radian over 0.5 cm exceed the curves by a few hundredths.
            EXPECT_LT(check.largest_ratio, 1.1) << named.name;
            EXPECT_GE(check.mean_ratio, 1) << named.name;
        }
    }
}

/// Chunks of one strand, so that no other strand extends the box, with few intervals.
TEST(ChunkBox, HoldsEachStrandByItself) {
    for (const BlendTraits& named : blends()) {
        for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
            for (const int n : {1, 2, 4, 8}) {
                const MadeHair hair(60, n, 7, 4, 4, n < 4 ? 0.1 : 0.5);
                const ExpandSettings settings{.blend = named.blend, .basis = basis};
                const Curves curves = expand(hair.binding, hair.profiles, settings);
                const Chunks chunks = chunks_of(hair.binding.roots.positions, 1);
                const ChunkCheck check = check_chunks(
                    hair.binding, hair.classed(settings.blend), curves, settings, chunks);
                EXPECT_EQ(check.chunks, 60u);
                EXPECT_TRUE(check.pass()) << named.name << ' ' << chunks_line(check);
            }
        }
    }
}

TEST(ChunkBox, TheCheckFindsAStrandOutsideAndAChangedStrand) {
    const MadeHair hair(200, 12, 8);
    const Chunks chunks = chunks_of(hair.binding.roots.positions, 50);
    Curves curves = expand(hair.binding, hair.profiles, {});
    curves.points[5 * curves.points_of(0) + 7].x += 40;
    curves.points[6 * curves.points_of(0) + 7].y =
        std::nextafter(curves.points[6 * curves.points_of(0) + 7].y, 1e9f);
    const ChunkCheck check =
        check_chunks(hair.binding, hair.classed(Blend::detail), curves, {}, chunks);
    EXPECT_EQ(check.outside, 1u);
    EXPECT_EQ(check.outside_reach, 1u);
    EXPECT_EQ(check.unlike, 2u);
    EXPECT_FALSE(check.pass());
}

TEST(ChunkBox, StrandsThatLeaveTheBoxAreCounted) {
    const MadeHair hair(200, 12, 8);
    Curves curves = expand(hair.binding, hair.profiles, {});
    const Eigen::AlignedBox3f box =
        chunk_box(hair.binding, hair.classed(Blend::detail), {}).box();
    EXPECT_EQ(strands_outside(curves, box), 0u);
    const std::size_t each = curves.points_of(0);
    curves.points[5 * each + 7].x += 40;
    EXPECT_EQ(strands_outside(curves, box), 1u);
    // Wider than the groom: outside of every side of the box.
    curves.points[6 * each + 7].w = 40;
    EXPECT_EQ(strands_outside(curves, box), 2u);
    // Half the box: strands in the other half and those that cross the middle.
    Eigen::AlignedBox3f half = box;
    half.max().x() = box.center().x();
    EXPECT_GT(strands_outside(curves, half), 20u);
    EXPECT_EQ(strands_outside(curves, Eigen::AlignedBox3f()), 200u);
}

TEST(ChunkBox, TheCheckFindsABoxThatIsTooSmall) {
    // The boxes are made for shorter strands than the curves have. A straight strand of
    // length L leaves a box that was made for 0.9 L by 0.1 L; bent ones, and those inside
    // of the chunk, may stay in it.
    const MadeHair hair(200, 12, 8, 4, 4, 0.05);
    const Chunks chunks = chunks_of(hair.binding.roots.positions, 50);
    const Curves curves = expand(hair.binding, hair.profiles, {});
    const auto check_at = [&](float share) {
        Binding shorter = hair.binding;
        for (float& length : shorter.lengths) length *= share;
        return check_chunks(shorter, hair.classed(Blend::detail), curves, {}, chunks);
    };
    EXPECT_TRUE(check_at(1).pass());
    EXPECT_GT(check_at(0.9f).outside, 0u);
    // The reach is longest (1.001 + 13 / 36) all round for 12 intervals: strands of at
    // least 8 cm leave a reach of at most 16 cm times 0.2 * 1.37.
    EXPECT_GT(check_at(0.2f).outside_reach, 100u);
    // Radii too: a box for hair of a tenth of its width.
    const Curves thick = expand(hair.binding, hair.profiles, {.taper = {0.5f, 0.5f}});
    const ChunkCheck thin = check_chunks(hair.binding, hair.classed(Blend::detail), thick,
                                         {.taper = {0.05f, 0.05f}}, chunks);
    EXPECT_GT(thin.outside, 0u);
    EXPECT_EQ(thin.outside_reach, 0u);
}

TEST(ChunkBox, OfTwoTimesHoldsStrandsInterpolatedBetweenThem) {
    const MadeHair hair(300, 12, 9, 4, 4, 0.5);
    // The same guides, turned by half a radian about Y.
    Guides later = hair.standing.guides;
    const Mat3 turn = Eigen::AngleAxisd(0.5, Vec3::UnitY()).toRotationMatrix();
    for (Mat3& frame : later.root_frames) frame = turn * frame;
    const auto profiles = guide_profiles<float>(later, hair.profiles.count);
    ChunkBox both = chunk_box(hair.binding, hair.classed(Blend::detail), {});
    both.extend(chunk_box(hair.binding,
                          test::one_class(profiles, hair.standing.normals, Blend::detail),
                          {}));
    const Eigen::AlignedBox3d box = both.box().cast<double>();
    const Curves a = expand(hair.binding, hair.profiles, {});
    const Curves b = expand(hair.binding, profiles, {});
    for (std::size_t i = 0; i < a.strands; ++i) {
        const EmittedStrand from = emitted_strand(a, i), to = emitted_strand(b, i);
        for (std::size_t j = 0; j < from.segments(); ++j) {
            for (const double time : {0.0, 0.3, 0.5, 1.0}) {
                const Vec3 p =
                    (1 - time) * from.position(j, 0.5) + time * to.position(j, 0.5);
                ASSERT_TRUE(box.contains(p)) << i;
            }
        }
    }
    // The box of the first time does not contain the second.
    const Eigen::AlignedBox3f first =
        chunk_box(hair.binding, hair.classed(Blend::detail), {}).box();
    EXPECT_FALSE(first.contains(test::box_of(b)));
}

/// The reach of a chunk, by the longest guide.
ChunkBox reach_of(const ChunkedGroom& groom, std::size_t chunk) {
    Eigen::AlignedBox3f roots;
    for (const std::uint32_t i : groom.chunks.of(chunk)) {
        roots.extend(place_of(groom, i));
    }
    const GroomSettings& settings = groom.ready.groom;
    const float longest = std::ranges::max(groom.ready.profiles.lengths);
    return reach_box(roots, longest * settings.bind.length_scale,
                     groom.ready.classes.counts.back(), settings.expand,
                     settings.density);
}

TEST(ChunkBox, ReachHoldsTheChunkForEveryBlend) {
    for (const BlendTraits& named : blends()) {
        GroomSettings groom = groom_to_cut();
        groom.expand.blend = named.blend;
        groom.intervals = 8;  // few, so that control points stray far from places
        groom.density = 0.5;
        const ChunkedGroom chunked = make_chunked_groom(groom, 200);
        for (std::size_t c = 0; c < chunked.chunks.size(); ++c) {
            const Eigen::AlignedBox3f reach = reach_of(chunked, c).box();
            EXPECT_TRUE(reach.contains(test::box_of(expanded(chunked, c)))) << named.name;
            const Binding binding = bind_chunk(chunked, c);
            EXPECT_TRUE(reach.contains(
                chunk_box(binding, rest_guides(chunked.ready), groom.expand).box()));
        }
    }
}

TEST(ChunkBox, OfNoStrandsIsEmpty) {
    const MadeHair hair(10, 8, 1);
    EXPECT_TRUE(chunk_box(picked(hair.binding, {}), hair.classed(Blend::detail), {})
                    .box()
                    .isEmpty());
}

TEST(Binding, PickedChildrenKeepTheirBits) {
    const MadeHair hair(100, 8, 4);
    const std::vector<std::uint32_t> which{3, 50, 51, 99};
    const Binding few = picked(hair.binding, which);
    EXPECT_EQ(few.roots.ids, which);
    const Curves all = expand(hair.binding, hair.profiles, {});
    const Curves some = expand(few, hair.profiles, {});
    for (std::size_t i = 0; i < which.size(); ++i) {
        const std::size_t n = all.points_of(0);
        EXPECT_EQ(std::memcmp(&some.points[i * n], &all.points[which[i] * n],
                              n * sizeof(Point4f)),
                  0);
    }
}

}  // namespace
}  // namespace lancret
