#include "tools/frames.h"

#include <fmt/format.h>

#include <charconv>
#include <regex>

#include "guides/errors.h"
#include "procedural/emission.h"

namespace lancret {

void add_frame_option(CLI::App& command, FrameOptions& options) {
    command.add_option("--frame", options.frame, "one frame of a cache, by its number")
        ->type_name("N");
}

void add_frames_options(CLI::App& command, FrameOptions& options) {
    add_frame_option(command, options);
    command.add_option("--frames", options.frames, "frames of a cache, by their numbers")
        ->type_name("A-B")
        ->check(not_empty())
        ->excludes("--frame");
}

std::pair<int, int> parse_frames(const std::string& text, const std::string& where) {
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto number = [&](int& value) {
        const auto [stop, error] = std::from_chars(at, end, value);
        at = stop;
        return error == std::errc();
    };
    int first = 0, last = 0;
    bool good = number(first);
    last = first;
    if (good && at != end) good = *at++ == '-' && number(last) && at == end;
    if (!good || last < first) {
        throw InputError(fmt::format(
            "{}: '{}' are no frames; give a number such as 12 or a range such as 1-96",
            where, text));
    }
    return {first, last};
}

ChosenFrames chosen_frames(const FrameOptions& options, const Job& job, bool all) {
    ChosenFrames out;
    const bool named = !job.groom.guides_file.empty();
    if (named || job.groom.strands_file.extension() == ".h5") {
        out.cache = named ? job.groom.guides_file : job.groom.strands_file;
    }
    const char* const option = options.frame ? "--frame" : "--frames";
    if (out.cache.empty()) {
        if (options.given()) {
            throw InputError(
                fmt::format("{}: {} is no cache (.h5) and so has no frames; simulate one",
                            option, job.groom.name));
        }
        out.frames = {0};
        return out;
    }
    out.info = guide_cache_info(out.cache);
    const int first = out.info.first_frame, last = first + (out.info.frames - 1);
    std::pair<int, int> range{first, all ? last : first};
    if (options.frame) range = {*options.frame, *options.frame};
    if (!options.frames.empty()) range = parse_frames(options.frames, option);
    if (range.first < first || range.second > last) {
        const int missing = range.first < first ? range.first : range.second;
        throw InputError(fmt::format(
            "{}: {} has no frame {}; it has {}", option, out.cache.string(), missing,
            first == last ? fmt::format("frame {} alone", first)
                          : fmt::format("frames {} to {}", first, last)));
    }
    for (std::int64_t f = range.first; f <= range.second; ++f)
        out.frames.push_back(int(f));
    return out;
}

RestPlaces prepare_frames(Generator& generator, const ChosenFrames& chosen,
                          const Job& job) {
    const RestPlaces rest = rest_places(generator.binding, generator.source);
    if (chosen.cache.empty() || chosen.info.frames < 2 || job.groom.intervals) {
        return rest;
    }
    constexpr int kMeasured = 13;
    const int n = std::min(kMeasured, chosen.info.frames);
    int intervals = generator.profiles.count;
    for (int i = 0; i < n; ++i) {
        const int frame =
            chosen.info.first_frame + (chosen.info.frames - 1) * i / std::max(n - 1, 1);
        const FrameState state = go_to_frame(generator, rest, chosen, job, frame);
        try {
            intervals = std::max(
                intervals,
                intervals_within(generator.binding, state.guides, job.groom.expand.blend,
                                 job.groom.tolerance, job.groom.expand.basis));
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: frame {}: {}", chosen.cache.string(), frame,
                                         error.what()));
        }
    }
    pose_binding(generator.binding, rest, RigidPose{});
    if (intervals != generator.profiles.count) {
        generator.profiles = guide_profiles<float>(generator.source.guides, intervals);
    }
    return rest;
}

FrameState go_to_frame(Generator& generator, const RestPlaces& rest,
                       const ChosenFrames& chosen, const Job& job, int frame) {
    FrameState out;
    if (chosen.cache.empty()) {
        out.guides = generator.source.guides;
    } else {
        out.guides = read_guide_cache(chosen.cache, frame - chosen.info.first_frame);
        if (job.pose_at) out.pose = job.pose_at(frame);
    }
    out.scalp_roots = pose_binding(generator.binding, rest, out.pose);
    out.profiles = guide_profiles<float>(out.guides, generator.profiles.count);
    return out;
}

std::filesystem::path picture_path(const std::filesystem::path& output, int frame,
                                   bool several) {
    const std::string name = output.filename().string();
    static const std::regex kPattern("#+|%(0?)([0-9]{0,2})d");
    std::smatch found;
    if (!std::regex_search(name, found, kPattern)) {
        if (!several) return output;
        return output.parent_path() / fmt::format("{}.{:04}{}", output.stem().string(),
                                                  frame, output.extension().string());
    }
    const bool hashes = found.str()[0] == '#';
    const int width = hashes                  ? int(found.length())
                      : found[2].length() > 0 ? std::stoi(found[2])
                                              : 1;
    // %4d pads with blanks in C; a file's name is better off with zeros.
    return output.parent_path() / fmt::format("{}{:0{}}{}", found.prefix().str(), frame,
                                              width, found.suffix().str());
}

}  // namespace lancret
