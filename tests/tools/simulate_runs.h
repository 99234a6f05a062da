#pragma once
// Simulations so small that a run takes about a second.

#include <nlohmann/json.hpp>

#include "tests/tools/reports.h"
#include "tests/tools/small_grooms.h"

namespace lancret {

/// SmallGrooms with groom.toml: the made head, which turns and nods, gusts, and a body in
/// the way of the hair.
struct MovingGroom : SmallGrooms {
    static constexpr const char* kText =
        "[guides]\nsegments = 6\n[guides.made]\nstrands = 40\n"
        "[strands]\ncount = 60\n"
        "[render]\nwidth = 32\nheight = 32\nsamples = 2\n"
        "[motion]\npivot = [0, -10, 0]\n"
        "keys = [{frame = 1}, {frame = 6, turn = [0, 50, 0]},\n"
        "        {frame = 12, turn = [10, -40, 0], move = [1, 0, 0]}]\n"
        "[dynamics.wind]\nturbulence = 30\n"
        "[[colliders]]\nshape = 'capsule'\nfrom = [-20, -18, 0]\nto = [20, -18, 0]\n"
        "radius = 6\n";
    std::string groom = file("groom.toml", kText);
    std::string cache = at("cache.h5");

    std::vector<std::string> words(const std::string& frames, const std::string& output,
                                   const std::vector<std::string>& more = {}) const {
        std::vector<std::string> out{"simulate", groom, "--frames", frames, "-o", output};
        out.insert(out.end(), more.begin(), more.end());
        return out;
    }
    CommandRun simulate(const std::string& frames, const std::string& output,
                        const std::vector<std::string>& more = {}) const {
        return lancret(words(frames, output, more));
    }
};

}  // namespace lancret
