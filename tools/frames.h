#pragma once
// What the subcommands share that look at a cache of several frames.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "guides/guide_cache.h"
#include "procedural/pose.h"
#include "tools/command.h"

namespace lancret {

/// --frame N and --frames A-B; at most one of them.
struct FrameOptions {
    std::optional<int> frame;
    std::string frames;

    bool given() const { return frame || !frames.empty(); }
};

void add_frame_option(CLI::App& command, FrameOptions& options);
/// The same and --frames.
void add_frames_options(CLI::App& command, FrameOptions& options);

/// The frames of a job's cache that a command works on, as an artist counts them.
struct ChosenFrames {
    std::filesystem::path cache;  ///< empty: the groom is no cache and holds still
    GuideCacheInfo info;          ///< of the cache
    std::vector<int> frames;      ///< at least one; where there is no cache, {0}
};

/// "12" or "1-96"; {first, last}. Throws InputError that begins with `where`.
std::pair<int, int> parse_frames(const std::string& text, const std::string& where);

/// The frames that the options ask for; by default those from `first` of the cache on,
/// all of them where `all`, else one. Throws InputError where there is no cache to choose
/// from, or where it has no such frame: then it says which it has.
ChosenFrames chosen_frames(const FrameOptions& options, const Job& job, bool all);

/// Everything of one frame that is not the same in all.
struct FrameState {
    Guides guides;
    GuideProfiles<float> profiles;
    std::vector<Vec3> scalp_roots;  ///< [guides], cm: where the scalp has their roots
    ScalpPose pose;                 ///< of the scalp
};

/// What `generator`'s binding is at rest; to be called before any frame. The points of a
/// strand are the same in all frames, so where a groom does not say how many intervals it
/// has, they are measured on frames spread over the whole cache too: hair that moves
/// bends more than hair at rest. Throws InputError.
RestPlaces prepare_frames(Generator& generator, const ChosenFrames& chosen,
                          const Job& job);

/// Brings `generator`'s binding to a frame of `chosen`. `rest` is what the binding was
/// before the first frame. Where the job knows no motion, the scalp stays at rest. Throws
/// InputError.
FrameState go_to_frame(Generator& generator, const RestPlaces& rest,
                       const ChosenFrames& chosen, const Job& job, int frame);

/// The file of a frame: "head.####.png" and "head.%04d.png" have the number in place of
/// the pattern; where there is none and `several` are written, it goes before the
/// extension, "head.0012.png".
std::filesystem::path picture_path(const std::filesystem::path& output, int frame,
                                   bool several);

}  // namespace lancret
