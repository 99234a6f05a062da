#pragma once
// A moving groom: a cache of two frames.

#include <cmath>
#include <string>

#include "guides/files/guide_cache.h"
#include "guides/files/guide_cache_write.h"
#include "tests/adapters/abi_groom.h"

namespace lancret {

/// turn.h5: the groom at rest at frame 1, rotated with the head by 15 degrees about the
/// neck at frame 2.
struct MovingGroom : MadeGroom {
    std::string cache = (*this / "turn.h5").string();

    MovingGroom() {
        std::string toml = read_bytes(path);
        write_bytes(path, toml +
                              "[motion]\npivot = [0, -8, -2]\n"
                              "keys = [{frame = 1}, {frame = 2, turn = [0, 15, 0]}]\n");
        const AbiGroom groom(path);
        lancret_guides from{};
        from.size = sizeof from;
        EXPECT_EQ(lancret_groom_get_guides(groom.groom, &from), LANCRET_OK);
        Guides rest;
        rest.segments = int(from.segments);
        for (std::size_t g = 0; g < from.guides; ++g) {
            rest.root_positions.emplace_back(
                Eigen::Map<const Vec3>(from.root_positions + 3 * g));
            rest.root_frames.emplace_back(
                Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
                    from.root_frames + 9 * g));
        }
        const std::size_t all = std::size_t(from.guides) * from.segments;
        rest.segment_lengths.assign(from.segment_lengths, from.segment_lengths + all);
        for (std::size_t i = 0; i < all; ++i) {
            rest.curvatures.emplace_back(Eigen::Map<const Vec3>(from.curvatures + 3 * i));
        }
        const Vec3 pivot(0, -8, -2);
        const Mat3 turn = Eigen::AngleAxisd(15 * kPi / 180, Vec3::UnitY()).matrix();
        Guides turned = rest;
        for (Vec3& root : turned.root_positions) root = pivot + turn * (root - pivot);
        for (Mat3& frame : turned.root_frames) frame = turn * frame;
        GuideCacheWriter writer(cache, {24, 1, path}, 2, &rest);
        writer.add(rest);
        writer.add(turned);
        writer.finish();
    }
};

}  // namespace lancret
