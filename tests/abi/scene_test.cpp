// What a host can query of a groom besides its curves.

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "procedural/check/values.h"
#include "procedural/groom/groom_source.h"
#include "procedural/groom/ready_groom.h"
#include "tests/abi/plugin.h"

namespace lancret {
namespace {

ReadyGroom ready_groom_of(const std::string& text) {
    GroomSource source;
    source.text = text;
    return make_ready_groom(read_groom_source(source).groom);
}

TriangleMesh head_of(const lancret_groom* groom, double time = 0) {
    TriangleMesh out;
    const auto sink = [](void* user, const lancret_mesh* mesh) {
        auto& to = *static_cast<TriangleMesh*>(user);
        for (std::size_t i = 0; i < mesh->vertices; ++i) {
            const float* p = mesh->positions + 3 * i;
            to.positions.emplace_back(p[0], p[1], p[2]);
        }
        for (std::size_t t = 0; t < mesh->triangles; ++t) {
            const lancret_u32* c = mesh->corners + 3 * t;
            to.triangles.push_back({c[0], c[1], c[2]});
        }
        return lancret_status(LANCRET_OK);
    };
    EXPECT_EQ(lancret_groom_get_head(groom, time, sink, &out), LANCRET_OK);
    return out;
}

struct OpenChunk {
    lancret_chunk* handle = nullptr;
    lancret_curves sizes{};

    OpenChunk(const lancret_groom* groom, lancret_u32 chunk,
              const lancret_options& options) {
        EXPECT_EQ(lancret_chunk_open(groom, chunk, &options, &handle), LANCRET_OK);
        sizes.size = sizeof sizes;
        EXPECT_EQ(lancret_chunk_get_sizes(handle, &sizes), LANCRET_OK);
    }
    ~OpenChunk() { lancret_chunk_close(handle); }
};

TEST(PluginScene, InfoHasBoxBasisAndShape) {
    const auto context = make_context();
    const ReadyGroom ready = ready_groom_of(kSmallGroom);
    const Eigen::AlignedBox3f box = guide_box(ready);
    const auto groom = opened(context.get(), kSmallGroom);
    const lancret_groom_info info = info_of(groom.get());
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(info.box[i], box.min()[i]);
        EXPECT_EQ(info.box[3 + i], box.max()[i]);
        EXPECT_LT(info.box[i], info.box[3 + i]);
    }
    EXPECT_EQ(info.frames, 0);
    EXPECT_EQ(info.basis, LANCRET_BSPLINE);
    EXPECT_EQ(info.shape, LANCRET_ANY_SHAPE);
    const auto shaped = [&](const char* settings) {
        return info_of(opened(context.get(), kSmallGroom + settings).get());
    };
    EXPECT_EQ(shaped("curve = 'hermite'\n").basis, LANCRET_HERMITE);
    EXPECT_EQ(shaped("shape = 'flat'\n").shape, LANCRET_FLAT);
    EXPECT_EQ(shaped("shape = 'round'\n").shape, LANCRET_ROUND);
    EXPECT_EQ(shaped("shape = 'ribbon'\n").shape, LANCRET_RIBBON);
}

TEST(PluginScene, TheHeadIsThatOfTheGroom) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    const ReadyGroom ready = ready_groom_of(kSmallGroom);
    const TriangleMesh head = head_of(groom.get());
    const PlacedGuides& placed = ready.placed;
    const TriangleMesh& mesh = placed.body ? *placed.body : placed.scalp->mesh;
    ASSERT_GT(head.triangles.size(), 100u);
    EXPECT_EQ(head.positions, mesh.positions);
    EXPECT_EQ(head.triangles, mesh.triangles);
    EXPECT_EQ(lancret_groom_get_head(
                  groom.get(), 0,
                  [](void*, const lancret_mesh*) { return lancret_status(7); }, nullptr),
              7);
    EXPECT_EQ(lancret_groom_get_head(groom.get(), 0, nullptr, nullptr), LANCRET_BAD_CALL);
}

TEST(PluginScene, DescriptionIsJson) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    std::string text;
    ASSERT_EQ(
        lancret_groom_describe(
            groom.get(),
            [](void* user, const char* json) { *static_cast<std::string*>(user) = json; },
            &text),
        LANCRET_OK);
    const auto json = nlohmann::json::parse(text);
    EXPECT_EQ(json.at("guides"), 60);
    EXPECT_EQ(json.at("groom_strands"), 200);
    EXPECT_EQ(json.at("blend"), "detail");
    EXPECT_GT(json.at("fit").at("rms_over_length_max"), 0);
}

TEST(PluginScene, FiguresAreThoseOfTheLibrary) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom, 5000);  // one chunk
    const ReadyGroom ready = ready_groom_of(kSmallGroom);
    const ClassedGuides classed = rest_guides(ready);
    const Blend blend = ready.groom.expand.blend;
    const OpenChunk chunk(groom.get(), 0, make_options(LANCRET_BSPLINE));
    ASSERT_EQ(chunk.sizes.strands, 3000u);
    const auto figures = [&](int figure, std::size_t count) {
        std::vector<float> out(count + 1, -7);
        EXPECT_EQ(lancret_chunk_get_figures(chunk.handle, figure, 0, out.data()),
                  LANCRET_OK);
        EXPECT_EQ(out.back(), -7) << "written beyond the end";
        out.pop_back();
        return out;
    };
    // n intervals have n + 3 points.
    const std::size_t intervals = chunk.sizes.points - 3 * chunk.sizes.strands;
    EXPECT_EQ(figures(LANCRET_CURVATURE, intervals),
              curvature_values(ready.binding, classed, blend).values);
    EXPECT_EQ(figures(LANCRET_TORSION, intervals),
              torsion_values(ready.binding, classed, blend).values);
    EXPECT_EQ(figures(LANCRET_ORTHOGONALITY, intervals + chunk.sizes.strands),
              orthogonality_values(ready.binding, classed, blend).values);
    for (const float error : figures(LANCRET_LENGTH_ERROR, chunk.sizes.strands)) {
        EXPECT_LE(error, 1e-5f);
    }
    float none = 0;
    EXPECT_EQ(lancret_chunk_get_figures(chunk.handle, LANCRET_REGION, 0, &none),
              LANCRET_BAD_INPUT);
    EXPECT_EQ(lancret_chunk_get_figures(chunk.handle, 99, 0, &none), LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_chunk_get_figures(chunk.handle, LANCRET_CURVATURE, 1, &none),
              LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_chunk_get_figures(chunk.handle, LANCRET_CURVATURE, 0, nullptr),
              LANCRET_BAD_CALL);
    lancret_chunk_info info{};
    info.size = sizeof info;
    ASSERT_EQ(lancret_chunk_get_info(chunk.handle, &info), LANCRET_OK);
    EXPECT_EQ(info.strands, 3000u);
    EXPECT_EQ(info.bytes, ready.binding.bytes());
    EXPECT_EQ(info.straight_guides, ready.binding.report.straight_guides);
}

TEST(PluginScene, WhatDoesNotMoveIsStill) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    const double times[] = {0, 5, 1e9};
    int still = 0;
    ASSERT_EQ(lancret_groom_is_still(groom.get(), times, 3, &still), LANCRET_OK);
    EXPECT_EQ(still, 1);
    const double odd[] = {0, std::numeric_limits<double>::quiet_NaN()};
    EXPECT_EQ(lancret_groom_is_still(groom.get(), odd, 2, &still), LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_is_still(groom.get(), times, 0, &still), LANCRET_BAD_CALL);
}

}  // namespace
}  // namespace lancret
