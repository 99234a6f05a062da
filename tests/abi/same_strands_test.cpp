#include <gtest/gtest.h>

#include <cstring>

#include "procedural/expand/faces.h"
#include "procedural/expand/intervals.h"
#include "procedural/groom/groom_source.h"
#include "procedural/groom/ready_groom.h"
#include "tests/abi/plugin.h"

namespace lancret {
namespace {

constexpr lancret_u32 kAll = LANCRET_TANGENTS | LANCRET_NORMALS | LANCRET_ROOT_UV |
                             LANCRET_LENGTHS | LANCRET_GUIDES | LANCRET_ARC_LENGTHS |
                             LANCRET_RANDOM;

ReadyGroom direct(const std::string& text, CurveBasis basis = CurveBasis::bspline) {
    GroomSource source;
    source.text = text;
    GroomSettings groom = read_groom_source(source).groom;
    groom.expand.basis = basis;
    return make_ready_groom(groom);
}

Curves curves_of(const ReadyGroom& ready) {
    return expand(ready.binding, rest_guides(ready), ready.groom.expand);
}

void expect_same_positions(const AllStrands& strands, const Curves& curves) {
    ASSERT_EQ(strands.size(), curves.strands);
    for (std::uint32_t i = 0; i < curves.strands; ++i) {
        const auto found = strands.find(curves.id_of(i));
        ASSERT_NE(found, strands.end());
        const std::size_t m = curves.points_of(i);
        const auto same = [&](const std::vector<float>& plugin,
                              const Buffer<Point4f>& library) {
            return plugin.size() == 4 * m &&
                   std::memcmp(plugin.data(), library.data() + curves.first_point(i),
                               m * sizeof(Point4f)) == 0;
        };
        ASSERT_TRUE(same(found->second.positions, curves.points)) << "strand " << i;
        if (curves.basis == CurveBasis::hermite) {
            ASSERT_TRUE(same(found->second.tangents, curves.tangents)) << "strand " << i;
        }
    }
}

TEST(Plugin, StrandsAreThoseOfTheLibraryBitForBit) {
    const auto context = make_context();
    int adapted = 0;
    for (const char* blend : {"detail", "position", "option1", "bishop"}) {
        const std::string text = kSmallGroom + "blend = \"" + blend + "\"\n";
        const auto groom = opened(context.get(), text, 700);
        for (const int basis : {LANCRET_BSPLINE, LANCRET_HERMITE}) {
            const Curves curves =
                curves_of(direct(text, basis == LANCRET_HERMITE ? CurveBasis::hermite
                                                                : CurveBasis::bspline));
            adapted += curves.classes.size() > 1;
            expect_same_positions(expanded(groom.get(), make_options(basis)), curves);
        }
    }
    EXPECT_GE(adapted, 4);  // Hermite curves of this groom have a single class
}

TEST(Plugin, StrandsAreThoseOfTheLibraryAtADensity) {
    const auto context = make_context();
    const ReadyGroom ready = direct(kSmallGroom + "density = 0.3\n");
    const auto groom = opened(context.get(), kSmallGroom, 512);
    auto options = make_options(LANCRET_BSPLINE);
    options.density = 0.3;
    expect_same_positions(expanded(groom.get(), options), curves_of(ready));
}

TEST(Plugin, StrandsAreTheSameForAnyChunksOrderAndThreads) {
    for (const int basis : {LANCRET_LINEAR, LANCRET_BSPLINE, LANCRET_CATMULL_ROM,
                            LANCRET_BEZIER, LANCRET_HERMITE}) {
        AllStrands first;
        for (const auto& [chunk, threads] : std::vector<std::pair<lancret_u32, int>>{
                 {0, 0}, {1, 1}, {333, 1}, {1000, 2}}) {
            if (chunk == 1 && basis != LANCRET_BEZIER) continue;  // 3000 calls are slow
            const lancret_host host = make_host(threads);
            const auto context = make_context(&host);
            const auto groom = opened(context.get(), kSmallGroom, chunk);
            const auto strands =
                expanded(groom.get(), make_options(basis, kAll), chunk == 333);
            EXPECT_EQ(strands.size(), 3000u);
            if (first.empty()) first = strands;
            EXPECT_TRUE(strands == first) << basis << ' ' << chunk;
        }
    }
}

TEST(Plugin, OtherBasesAreTheSameCurves) {
    // Bezier points are Hermite points and a third of their tangents, within the rounding
    // of float at 30 cm: a few 1e-6.
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    const auto hermite = expanded(groom.get(), make_options(LANCRET_HERMITE));
    const auto bezier = expanded(groom.get(), make_options(LANCRET_BEZIER));
    for (const auto& [id, strand] : hermite) {
        const std::vector<float>&p = strand.positions, &t = strand.tangents,
              &b = bezier.at(id).positions;
        const std::size_t n = p.size() / 4 - 1;
        ASSERT_EQ(b.size(), 4 * (3 * n + 1));
        for (std::size_t i = 0; i < n; ++i) {
            for (int c = 0; c < 3; ++c) {
                ASSERT_EQ(b[12 * i + c], p[4 * i + c]);
                ASSERT_NEAR(b[12 * i + 4 + c], p[4 * i + c] + t[4 * i + c] / 3, 1e-5);
                ASSERT_NEAR(b[12 * i + 8 + c], p[4 * i + 4 + c] - t[4 * i + 4 + c] / 3,
                            1e-5);
            }
        }
    }
}

TEST(Plugin, MaxErrorHoldsInEveryBasis) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    for (const float error : {0.1f, 0.01f, 1e-3f}) {
        for (const int basis : {LANCRET_LINEAR, LANCRET_BSPLINE, LANCRET_CATMULL_ROM,
                                LANCRET_BEZIER, LANCRET_HERMITE}) {
            // The finest ones are slow; test two of the bases.
            const bool slow = error < 0.01f && basis != LANCRET_BSPLINE;
            if (slow && basis != LANCRET_HERMITE) continue;
            auto options = make_options(basis);
            options.max_error = error;
            lancret_check check{};
            check.size = sizeof check;
            ASSERT_EQ(lancret_groom_check_chunk(groom.get(), 0, &options, &check),
                      LANCRET_OK);
            EXPECT_EQ(check.strands, 3000u);
            EXPECT_LE(check.distance, error) << basis;
            // And the strands are not much finer than necessary.
            EXPECT_GT(check.distance, error / 100) << basis;
            EXPECT_EQ(check.outside, 0u) << basis;
            EXPECT_LE(check.orthogonality, 1e-6);
            EXPECT_LE(check.length_error, 1e-5);
        }
    }
}

TEST(Plugin, AnErrorThatCannotBeMetIsLogged) {
    std::vector<std::string> warnings;
    lancret_host host = make_host(1);  // logs from one thread
    host.user = &warnings;
    host.log = [](void* user, int level, const char* text) {
        if (level != LANCRET_LOG_WARNING) return;
        static_cast<std::vector<std::string>*>(user)->emplace_back(text);
    };
    const auto context = make_context(&host);
    const auto groom = opened(context.get(), kSmallGroom);
    const auto request = [&](int basis) {
        auto options = make_options(basis);
        options.max_error = 1e-4f;
        float box[6];
        EXPECT_EQ(
            lancret_groom_get_chunk_box(groom.get(), 0, &options, LANCRET_REACH, box),
            LANCRET_OK);
    };
    request(LANCRET_HERMITE);
    EXPECT_TRUE(warnings.empty());
    // Chords of 1/1024 of these curls deviate by more.
    request(LANCRET_LINEAR);
    request(LANCRET_LINEAR);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("more than the requested 0.0001 cm"), std::string::npos)
        << warnings[0];
}

}  // namespace
}  // namespace lancret
