#pragma once
// What the subcommands share that look at a cache of several frames.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "procedural/motion/groom_times.h"

namespace lancret {

struct Job;

/// --frame N (12 or 12.25) and --frames A-B; at most one of them.
struct FrameOptions {
    std::optional<double> frame;  ///< may lie between two
    std::string frames;

    bool given() const { return frame || !frames.empty(); }
};

void add_frame_option(CLI::App& command, FrameOptions& options);
/// The same and --frames.
void add_frames_options(CLI::App& command, FrameOptions& options);

/// The frames of a job's cache that a command works on, as an artist counts them.
struct ChosenFrames : GroomTimes {
    std::vector<double> frames;  ///< at least one; where there is no cache, {0}
};

/// "12" or "1-96"; {first, last}. Throws InputError that begins with `where`.
std::pair<int, int> parse_frames(const std::string& text, const std::string& where);

/// The frames that the options ask for; by default those from `first` of the cache on,
/// all of them where `all`, else one. Throws InputError where there is no cache to choose
/// from, or where it has no such frame: then it says which it has.
ChosenFrames chosen_frames(const FrameOptions& options, const Job& job, bool all);

/// The times at which a picture of `frame` needs its strands, as frames.
struct ShutterTimes {
    std::vector<double> frames;  ///< evenly spread; one where nothing moves
    bool cut = false;            ///< the cache ends inside the shutter, which ends there
};

/// The times of a shutter that is open from `shutter[0]` to `shutter[1]` frames after
/// `frame`, `samples` (>= 2) of them; the frame alone without a shutter or a cache.
ShutterTimes shutter_times(const ChosenFrames& chosen, double frame,
                           const std::optional<Vec2>& shutter, int samples);

/// The file of a frame: "head.####.png" and "head.%04d.png" have the number in place of
/// the pattern; where there is none and `several` are written, it goes before the
/// extension, "head.0012.png". Of a part of a frame the whole part is padded and the
/// decimals (six at most) follow it: "head.0012.25.png".
std::filesystem::path picture_path(const std::filesystem::path& output, double frame,
                                   bool several);

}  // namespace lancret
