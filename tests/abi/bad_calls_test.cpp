#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/abi/plugin.h"

namespace lancret {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

lancret_status ignore(void*, const lancret_curves*) { return LANCRET_OK; }

TEST(PluginCalls, NullsAreRefused) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    lancret_groom* out = nullptr;
    const auto source = text_source(kSmallGroom);
    float box[6];
    EXPECT_EQ(lancret_context_create(LANCRET_ABI_VERSION, nullptr, nullptr),
              LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_open(nullptr, &source, &out, nullptr, 0), LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_open(context.get(), nullptr, &out, nullptr, 0),
              LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_open(context.get(), &source, nullptr, nullptr, 0),
              LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_get_info(groom.get(), nullptr), LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_get_info(nullptr, nullptr), LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_get_guides(groom.get(), nullptr), LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_expand_chunk(groom.get(), 0, nullptr, nullptr, nullptr),
              LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_expand_chunk(nullptr, 0, nullptr, ignore, nullptr),
              LANCRET_BAD_CALL);
    EXPECT_EQ(
        lancret_groom_get_chunk_box(groom.get(), 0, nullptr, LANCRET_REACH, nullptr),
        LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_get_chunk_box(groom.get(), 0, nullptr, 7, box),
              LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_chunk_open(groom.get(), 0, nullptr, nullptr), LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_chunk_get_sizes(nullptr, nullptr), LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_chunk_write(nullptr, nullptr), LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_check_chunk(groom.get(), 0, nullptr, nullptr),
              LANCRET_BAD_CALL);
    EXPECT_EQ(
        lancret_context_evaluate(context.get(), &source, nullptr, nullptr, nullptr, 0),
        LANCRET_BAD_CALL);
    lancret_groom_close(nullptr);
    lancret_chunk_close(nullptr);
    lancret_context_destroy(nullptr);
    // Null options are the defaults.
    EXPECT_EQ(lancret_groom_expand_chunk(groom.get(), 0, nullptr, ignore, nullptr),
              LANCRET_OK);
}

TEST(PluginCalls, OptionsOutOfRangeAreRefused) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    const auto status = [&](auto change) {
        auto options = make_options(LANCRET_BSPLINE);
        change(options);
        return lancret_groom_expand_chunk(groom.get(), 0, &options, ignore, nullptr);
    };
    const double nan = kNaN;
    EXPECT_EQ(status([](auto&) {}), LANCRET_OK);
    EXPECT_EQ(status([](auto& o) { o.basis = 5; }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.basis = -1; }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.density = kNaN; }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.density = 1.5; }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.density = -1; }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.max_error = float(kNaN); }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.max_error = 1e-30f; }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.unit = -1; }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.unit = float(kNaN); }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.pixels = kNaN; }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.attributes = 1u << 30; }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([](auto& o) { o.time_count = 1; }), LANCRET_BAD_CALL);
    EXPECT_EQ(status([&](auto& o) { o.times = &nan, o.time_count = 1; }),
              LANCRET_BAD_CALL);
    EXPECT_EQ(status([&](auto& o) { o.times = &nan, o.time_count = 257; }),
              LANCRET_BAD_CALL);
    EXPECT_EQ(lancret_groom_expand_chunk(groom.get(), 1, nullptr, ignore, nullptr),
              LANCRET_BAD_CALL);
}

TEST(PluginCalls, SizesDistinguishOldAndNewCallers) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    // A caller without the fields after the basis: they are not read.
    lancret_options options = make_options(LANCRET_BSPLINE);
    options.size = offsetof(lancret_options, max_error);
    options.density = kNaN;
    EXPECT_EQ(lancret_groom_expand_chunk(groom.get(), 0, &options, ignore, nullptr),
              LANCRET_OK);
    options.size = 0;
    EXPECT_EQ(lancret_groom_expand_chunk(groom.get(), 0, &options, ignore, nullptr),
              LANCRET_BAD_CALL);
    options.size = std::size_t(-1);
    EXPECT_EQ(lancret_groom_expand_chunk(groom.get(), 0, &options, ignore, nullptr),
              LANCRET_BAD_CALL);
    // A newer caller: fields that the library lacks must be zero.
    struct Later {
        lancret_options known;
        double more[2];
    } later{make_options(LANCRET_BSPLINE), {0, 0}};
    later.known.size = sizeof later;
    EXPECT_EQ(lancret_groom_expand_chunk(groom.get(), 0, &later.known, ignore, nullptr),
              LANCRET_OK);
    later.more[1] = 1;
    EXPECT_EQ(lancret_groom_expand_chunk(groom.get(), 0, &later.known, ignore, nullptr),
              LANCRET_BAD_CALL);
    // Fields that the caller lacks are not written.
    lancret_groom_info info{};
    info.size = offsetof(lancret_groom_info, guides);
    info.guides = 12345;
    EXPECT_EQ(lancret_groom_get_info(groom.get(), &info), LANCRET_OK);
    EXPECT_EQ(info.strands, 3000u);
    EXPECT_EQ(info.guides, 12345u);
    EXPECT_EQ(info.size, offsetof(lancret_groom_info, guides));
}

TEST(PluginCalls, ErrorsNameFileAndLine) {
    const auto context = make_context();
    const std::string text = "[strands]\ncount = 100\nwidht = 3\n";
    lancret_source source = text_source(text);
    source.path = "some/head.toml";
    auto out = open(context.get(), source);
    EXPECT_EQ(out.status, LANCRET_BAD_INPUT);
    EXPECT_EQ(out.error.find("some/head.toml:3: unknown key 'widht'"), 0u) << out.error;
    char small[10];
    lancret_groom* groom = nullptr;
    EXPECT_EQ(lancret_groom_open(context.get(), &source, &groom, small, sizeof small),
              LANCRET_BAD_INPUT);
    EXPECT_STREQ(small, "some/head");
    EXPECT_EQ(groom, nullptr);
}

TEST(PluginCalls, ParametersAreValidatedLikeTheFile) {
    const auto context = make_context();
    const auto with = [&](lancret_parameter parameter) {
        lancret_source source = text_source(kSmallGroom);
        source.parameters = &parameter;
        source.parameter_count = 1;
        return open(context.get(), source);
    };
    EXPECT_EQ(info_of(with({"strands.count", nullptr, 50}).groom.get()).strands, 50u);
    EXPECT_EQ(info_of(with({"guides.made.strands", nullptr, 30}).groom.get()).guides,
              30u);
    EXPECT_EQ(with({"strands.facing", nullptr, 0}).status, LANCRET_OK);
    EXPECT_EQ(with({"strands.blend", "position", 0}).status, LANCRET_OK);
    EXPECT_EQ(with({"width.root", nullptr, 0.02}).status, LANCRET_OK);
    const auto fault = [&](lancret_parameter parameter) {
        const auto out = with(parameter);
        EXPECT_EQ(out.status, LANCRET_BAD_INPUT) << parameter.name;
        return out.error;
    };
    EXPECT_EQ(
        fault({"strands.count", nullptr, 0}),
        "groom: parameter count: 'count' is 0, but must be between 1 and 100000000");
    EXPECT_NE(fault({"strands.number", nullptr, 5}).find("unknown key 'number'"),
              std::string::npos);
    EXPECT_NE(fault({"strands.count", nullptr, 1.5}).find("whole number"),
              std::string::npos);
    EXPECT_NE(fault({"strands.blend", "detial", 0}).find("did you mean 'detail'"),
              std::string::npos);
    EXPECT_NE(fault({"strands.facing", nullptr, 2}).find("true or false"),
              std::string::npos);
    fault({"width.root", nullptr, kNaN});
    fault({"width.root", nullptr, INFINITY});
    fault({"", nullptr, 1});
    fault({".", nullptr, 1});
    fault({"strands.", nullptr, 1});
    fault({"strands.count.x", nullptr, 1});
    fault({"strands", "x", 1});
    EXPECT_EQ(with({nullptr, nullptr, 1}).status, LANCRET_BAD_CALL);
}

TEST(PluginCalls, AnEmptyPathIsNoGroom) {
    const auto context = make_context();
    lancret_source source = text_source(kSmallGroom);
    source.path = "";
    const auto out = open(context.get(), source);
    EXPECT_EQ(out.status, LANCRET_BAD_CALL);
    EXPECT_EQ(out.error, "lancret_source: path is empty");
}

TEST(PluginCalls, AnErrorIsOneLine) {
    const auto context = make_context();
    lancret_source source = text_source(kSmallGroom);
    const lancret_parameter parameter{"strands.a\nb\r\tc", nullptr, 1};
    source.parameters = &parameter;
    source.parameter_count = 1;
    const auto out = open(context.get(), source);
    EXPECT_EQ(out.status, LANCRET_BAD_INPUT);
    EXPECT_NE(out.error.find("unknown key 'a b  c' in [strands]"), std::string::npos)
        << out.error;
}

TEST(PluginCalls, UnalignedBuffersAreRefused) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    const auto options = make_options(LANCRET_BSPLINE);
    lancret_chunk* chunk = nullptr;
    ASSERT_EQ(lancret_chunk_open(groom.get(), 0, &options, &chunk), LANCRET_OK);
    lancret_curves curves{};
    curves.size = sizeof curves;
    ASSERT_EQ(lancret_chunk_get_sizes(chunk, &curves), LANCRET_OK);
    std::vector<float> memory(4 * std::size_t(curves.points) + 8);
    const auto offset =
        reinterpret_cast<std::uintptr_t>(memory.data()) % 16 / sizeof(float);
    const float* aligned = memory.data() + (4 - offset) % 4;
    for (int shift = 0; shift < 4; ++shift) {
        const float* positions[] = {aligned + shift};
        curves.positions = positions;
        EXPECT_EQ(lancret_chunk_write(chunk, &curves),
                  shift == 0 ? LANCRET_OK : LANCRET_BAD_CALL);
    }
    lancret_chunk_close(chunk);
}

}  // namespace
}  // namespace lancret
