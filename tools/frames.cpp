#include "tools/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <regex>

#include "guides/base/errors.h"
#include "tools/job.h"
#include "tools/options.h"

namespace lancret {

void add_frame_option(CLI::App& command, FrameOptions& options) {
    command
        .add_option("--frame", options.frame,
                    "frame number of a cache; 12.25 lies between two frames")
        ->type_name("N");
}

void add_frames_options(CLI::App& command, FrameOptions& options) {
    add_frame_option(command, options);
    command.add_option("--frames", options.frames, "range of frames of a cache")
        ->type_name("A-B")
        ->check(not_empty())
        ->excludes("--frame");
}

std::pair<int, int> parse_frames(const std::string& text, const std::string& where) {
    const char* next = text.data();
    const char* const end = next + text.size();
    const auto number = [&](int& value) {
        const auto [stop, error] = std::from_chars(next, end, value);
        next = stop;
        return error == std::errc();
    };
    int first = 0, last = 0;
    bool good = number(first);
    last = first;
    if (good && next != end) good = *next++ == '-' && number(last) && next == end;
    if (!good || last < first) {
        throw InputError(fmt::format(
            "{}: invalid frames '{}': expected a number such as 12 or a range such as "
            "1-96",
            where, text));
    }
    return {first, last};
}

ChosenFrames chosen_frames(const FrameOptions& options, const Job& job, bool all) {
    ChosenFrames out;
    static_cast<GroomTimes&>(out) = groom_times(job.groom, job.pose_at);
    const char* const option = options.frame ? "--frame" : "--frames";
    if (out.cache.empty()) {
        if (options.given()) {
            throw InputError(
                fmt::format("{}: {} is not a guide cache (.h5) and has no frames; "
                            "make one with lancret simulate",
                            option, job.groom.name));
        }
        out.frames = {0};
        return out;
    }
    const int first = out.first(), last = out.last();
    std::pair<double, double> range{first, all ? last : first};
    if (options.frame) range = {*options.frame, *options.frame};
    if (!options.frames.empty()) range = parse_frames(options.frames, option);
    // A NaN fails both comparisons.
    if (!(range.first >= first && range.second <= last)) {
        const double missing = range.second > last ? range.second : range.first;
        throw InputError(fmt::format(
            "{}: {} has no frame {}; it has {}", option, out.cache.string(), missing,
            first == last ? fmt::format("only frame {}", first)
                          : fmt::format("frames {} to {}", first, last)));
    }
    for (double f = range.first; f <= range.second; ++f) out.frames.push_back(f);
    return out;
}

ShutterTimes shutter_times(const ChosenFrames& chosen, double frame,
                           const std::optional<Vec2>& shutter, int samples) {
    if (!shutter || chosen.cache.empty()) return {{frame}, false};
    const double first = chosen.first(), last = chosen.last();
    const double opens = frame + shutter->x(), closes = frame + shutter->y();
    const double from = std::clamp(opens, first, last),
                 to = std::clamp(closes, first, last);
    ShutterTimes out{{from}, from != opens || to != closes};
    if (to > from) {
        for (int i = 1; i < samples; ++i) {
            out.frames.push_back(
                i + 1 == samples ? to : from + (to - from) * i / (samples - 1));
        }
    }
    return out;
}

namespace {

/// The frame number with its integer part padded to at least `width` characters.
std::string padded(double frame, int width) {
    std::string text = fmt::format("{:.6f}", frame);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    const std::size_t whole = std::min(text.find('.'), text.size());
    if (whole < std::size_t(width)) {
        text.insert(text[0] == '-' ? 1 : 0, std::size_t(width) - whole, '0');
    }
    return text;
}

}  // namespace

std::filesystem::path picture_path(const std::filesystem::path& output, double frame,
                                   bool several) {
    const std::string name = output.filename().string();
    static const std::regex kPattern("#+|%(0?)([0-9]{0,2})d");
    std::smatch found;
    if (!std::regex_search(name, found, kPattern)) {
        if (!several) return output;
        return output.parent_path() / (output.stem().string() + "." + padded(frame, 4) +
                                       output.extension().string());
    }
    const bool hashes = found.str()[0] == '#';
    const int width = hashes                  ? int(found.length())
                      : found[2].length() > 0 ? std::stoi(found[2])
                                              : 1;
    // %4d pads with blanks in C; zeros suit file names better.
    return output.parent_path() /
           (found.prefix().str() + padded(frame, width) + found.suffix().str());
}

}  // namespace lancret
