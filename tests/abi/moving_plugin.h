#pragma once
// A moving groom for tests of the C interface.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "guides/files/guide_cache.h"
#include "guides/files/guide_cache_write.h"
#include "procedural/groom/groom_source.h"
#include "procedural/groom/head_pose.h"
#include "procedural/groom/ready_groom.h"
#include "procedural/motion/moving_groom.h"
#include "tests/abi/plugin.h"

namespace lancret {

/// A groom whose head moves and rotates and whose guides bend, from frame 3 to 6.
class MovingPlugin : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() /
                  ("lancret_abi_time_" + std::to_string(getpid()));
        std::filesystem::create_directory(folder_);
        std::ofstream(folder_ / "head.toml")
            << kSmallGroom << "[motion]\npivot = [0, -5, 0]\n"
            << "[[motion.keys]]\nframe = 3\n[[motion.keys]]\nframe = 6\n"
            << "move = [4, 1, -2]\nturn = [0, 40, 10]\n";
        GroomSource source;
        source.path = folder_ / "head.toml";
        const SourcedGroom groom = read_groom_source(source);
        const ReadyGroom ready = make_ready_groom(groom.groom);
        const ScalpPoseAt pose = head_pose(groom.motion, groom.groom);
        std::vector<Guides> frames;
        for (int f = 3; f <= 6; ++f) {
            Guides guides = ready.placed.guides;
            const auto head = std::get<RigidPose>(pose(f));
            for (std::size_t g = 0; g < guides.size(); ++g) {
                guides.root_positions[g] = head * guides.root_positions[g];
                guides.root_frames[g] = head.rotation * guides.root_frames[g];
            }
            for (Vec3& k : guides.curvatures) k.y() += 0.02 * (f - 3);
            frames.push_back(std::move(guides));
        }
        cache_ = (folder_ / "head.h5").string();
        GuideCacheWriter writer(cache_, {24, 3, (folder_ / "head.toml").string()}, 4,
                                &ready.placed.guides);
        for (const Guides& frame : frames) writer.add(frame);
        writer.finish();
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    GroomHandle open_cache(lancret_context* context, lancret_u32 chunk = 0) {
        lancret_source source{};
        source.size = sizeof source;
        source.path = cache_.c_str();
        source.chunk_strands = chunk;
        Opened out = open(context, source);
        EXPECT_EQ(out.status, LANCRET_OK) << out.error;
        return std::move(out.groom);
    }

    std::filesystem::path folder_;
    std::string cache_;
};

}  // namespace lancret
