#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "procedural/curves/emitted_curve.h"
#include "procedural/groom/head_pose.h"
#include "tests/abi/moving_plugin.h"

namespace lancret {
namespace {

using PluginTime = MovingPlugin;

TEST_F(PluginTime, StrandsAreThoseOfTheLibraryAtAndBetweenFrames) {
    const auto context = make_context();
    const auto groom = open_cache(context.get(), 800);
    const lancret_groom_info info = info_of(groom.get());
    EXPECT_EQ(info.first_frame, 3);
    EXPECT_EQ(info.last_frame, 6);
    GroomSource source;
    source.path = cache_;
    const SourcedGroom sourced = read_groom_source(source);
    ReadyGroom ready = make_ready_groom(sourced.groom);
    const GroomTimes times =
        groom_times(sourced.groom, head_pose(sourced.motion, sourced.groom));
    const RestPlaces rest = prepare_frames(ready, times);
    // One of them twice, and one beyond the end, which is clamped.
    const std::vector<double> requested = {3, 4.25, 6, 4.25, 100};
    auto options = make_options(LANCRET_BSPLINE);
    options.times = requested.data();
    options.time_count = requested.size();
    for (std::size_t t = 0; t < requested.size(); ++t) {
        const FrameState state =
            go_to_frame(ready, rest, times, std::min(requested[t], 6.0));
        const Curves curves = expand(ready.binding, state.classed, ready.groom.expand);
        const auto strands = expanded(groom.get(), options, false, t);
        ASSERT_EQ(strands.size(), curves.strands);
        std::map<std::uint32_t, std::uint32_t> places;
        for (std::uint32_t i = 0; i < curves.strands; ++i) places[curves.id_of(i)] = i;
        for (const auto& [id, strand] : strands) {
            const std::uint32_t place = places.at(id), m = curves.points_of(place);
            ASSERT_EQ(strand.positions.size(), 4 * std::size_t(m));
            ASSERT_EQ(std::memcmp(strand.positions.data(),
                                  curves.points.data() + curves.first_point(place),
                                  m * sizeof(Point4f)),
                      0)
                << requested[t];
        }
    }
}

TEST_F(PluginTime, WhatMovesIsNotStill) {
    const auto context = make_context();
    const auto groom = open_cache(context.get());
    const auto still = [&](std::vector<double> times) {
        int out = -1;
        EXPECT_EQ(lancret_groom_is_still(groom.get(), times.data(), times.size(), &out),
                  LANCRET_OK);
        return out;
    };
    EXPECT_EQ(still({3, 4}), 0);
    EXPECT_EQ(still({3, 3, 5.5}), 0);
    EXPECT_EQ(still({4.5, 4.5}), 1);
    EXPECT_EQ(still({6, 100}), 1);  // clamped to the end
    EXPECT_EQ(info_of(groom.get()).frames, 4);
}

/// visit(position and radius) at quarters of each segment of Hermite curves whose points
/// move linearly from each time to the next: at the times and at thirds between them.
template <class Visit>
void each_place_between(const lancret_curves& c, const Visit& visit) {
    const auto point = [&](const float* const* values, std::size_t time, float share,
                           std::size_t p) {
        const float *a = values[time] + 4 * p, *b = values[time + 1] + 4 * p;
        const auto mix = [&](int i) { return (1 - share) * a[i] + share * b[i]; };
        return Point4f{mix(0), mix(1), mix(2), mix(3)};
    };
    for (std::size_t time = 0; time + 1 < c.times; ++time) {
        for (int third = 0; third <= 3; ++third) {
            const float share = float(third) / 3;
            std::size_t first = 0;
            for (std::size_t i = 0; i < c.strands; first += c.counts[i++]) {
                std::vector<Point4f> places, tangents;
                for (std::size_t p = first; p < first + c.counts[i]; ++p) {
                    places.push_back(point(c.positions, time, share, p));
                    tangents.push_back(point(c.tangents, time, share, p));
                }
                for (std::size_t j = 0; j + 1 < places.size(); ++j) {
                    for (const float t : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
                        const Vec3f at =
                            emitted_place(CurveBasis::hermite, places, tangents, j, t);
                        const float r = 1 - t;
                        visit({at.x(), at.y(), at.z(),
                               r * r * (1 + 2 * t) * places[j].w +
                                   t * t * (3 - 2 * t) * places[j + 1].w +
                                   t * r * r * tangents[j].w -
                                   t * t * r * tangents[j + 1].w});
                    }
                }
            }
        }
    }
}

TEST_F(PluginTime, BoxesHoldAllTimesAndBetween) {
    const auto context = make_context();
    const auto groom = open_cache(context.get(), 800);
    const std::vector<double> requested = {3.5, 4, 5.5};
    auto options = make_options(LANCRET_HERMITE);
    options.times = requested.data();
    options.time_count = requested.size();
    for (const int kind : {LANCRET_REACH, LANCRET_TIGHT}) {
        for (lancret_u32 chunk = 0; chunk < info_of(groom.get()).chunks; ++chunk) {
            float box[6];
            ASSERT_EQ(
                lancret_groom_get_chunk_box(groom.get(), chunk, &options, kind, box),
                LANCRET_OK);
            std::size_t outside = 0, visits = 0;
            const auto look = [&](const lancret_curves& c) {
                EXPECT_EQ(c.times, 3u);
                each_place_between(c, [&](const Point4f& at) {
                    // Sums of eight coordinates of 20 cm, rounded to float.
                    constexpr float kRounding = 8 * 20 * 6e-8f;
                    const Vec3f p = at.xyz();
                    const float reach = at.w - kRounding;
                    ++visits;
                    for (int a = 0; a < 3; ++a) {
                        outside +=
                            !(p[a] - reach >= box[a] && p[a] + reach <= box[3 + a]);
                    }
                });
                return LANCRET_OK;
            };
            ASSERT_EQ(expand_with(groom.get(), chunk, options, look), LANCRET_OK);
            EXPECT_EQ(outside, 0u);
            EXPECT_GT(visits, 10000u);
        }
    }
}

TEST_F(PluginTime, BuffersGetWhatASinkGets) {
    const auto context = make_context();
    const auto groom = open_cache(context.get());
    const std::vector<double> requested = {3, 5.5};
    auto options = make_options(LANCRET_CATMULL_ROM);
    options.times = requested.data();
    options.time_count = 2;
    lancret_chunk* chunk = nullptr;
    ASSERT_EQ(lancret_chunk_open(groom.get(), 0, &options, &chunk), LANCRET_OK);
    lancret_curves curves{};
    curves.size = sizeof curves;
    ASSERT_EQ(lancret_chunk_get_sizes(chunk, &curves), LANCRET_OK);
    std::vector<Point4f> first(curves.points), second(curves.points);
    const float* positions[] = {&first[0].x, &second[0].x};
    std::vector<lancret_u32> ids(curves.strands);
    curves.positions = positions;
    curves.ids = ids.data();
    ASSERT_EQ(lancret_chunk_write(chunk, &curves), LANCRET_OK);
    lancret_chunk_close(chunk);
    const auto look = [&](const lancret_curves& c) {
        const std::size_t bytes = curves.points * sizeof(Point4f);
        EXPECT_EQ(std::memcmp(c.positions[0], first.data(), bytes), 0);
        EXPECT_EQ(std::memcmp(c.positions[1], second.data(), bytes), 0);
        EXPECT_NE(std::memcmp(c.positions[0], second.data(), bytes), 0);
        return LANCRET_OK;
    };
    EXPECT_EQ(expand_with(groom.get(), 0, options, look), LANCRET_OK);
    EXPECT_EQ(std::ranges::max(ids), 2999u);
}

}  // namespace
}  // namespace lancret
