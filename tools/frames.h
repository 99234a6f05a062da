#pragma once
// Frames of a guide cache, for the subcommands that work on one or several.

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
    std::optional<double> frame;  ///< may lie between two frames of the cache
    std::string frames;

    bool given() const { return frame || !frames.empty(); }
};

void add_frame_option(CLI::App& command, FrameOptions& options);
/// Adds --frame and --frames.
void add_frames_options(CLI::App& command, FrameOptions& options);

/// The frames of a job's cache that a command works on, by frame number.
struct ChosenFrames : GroomTimes {
    std::vector<double> frames;  ///< at least one; {0} without a cache
};

/// {first, last} of "12" or "1-96". Throws InputError, prefixed with `where`.
std::pair<int, int> parse_frames(const std::string& text, const std::string& where);

/// The requested frames of the job's cache; without a request all of them if `all`,
/// otherwise the first. Throws InputError if frames are requested that the cache does not
/// have, or without a cache.
ChosenFrames chosen_frames(const FrameOptions& options, const Job& job, bool all);

/// The times at which a picture needs its strands, as frame numbers.
struct ShutterTimes {
    std::vector<double> frames;  ///< evenly spaced; a single one if nothing moves
    bool cut = false;            ///< the shutter interval was clipped to the cache
};

/// The `samples` (>= 2) times of a shutter that is open from `shutter[0]` to `shutter[1]`
/// frames relative to `frame`; only `frame` without a shutter or a cache.
ShutterTimes shutter_times(const ChosenFrames& chosen, double frame,
                           const std::optional<Vec2>& shutter, int samples);

/// The file of a frame. The frame number replaces the pattern in "head.####.png" or
/// "head.%04d.png". Without a pattern it is inserted before the extension if `several`
/// pictures are written: "head.0012.png". The integer part is padded; up to six decimals
/// follow: "head.0012.25.png".
std::filesystem::path picture_path(const std::filesystem::path& output, double frame,
                                   bool several);

}  // namespace lancret
