#include "tools/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <regex>

#include "guides/errors.h"
#include "guides/guides_between.h"
#include "procedural/class_choice.h"
#include "procedural/emission.h"

namespace lancret {

void add_frame_option(CLI::App& command, FrameOptions& options) {
    command
        .add_option("--frame", options.frame,
                    "one frame of a cache, by its number; 12.25 lies between two")
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
    const int first = out.first(), last = out.last();
    std::pair<double, double> range{first, all ? last : first};
    if (options.frame) range = {*options.frame, *options.frame};
    if (!options.frames.empty()) range = parse_frames(options.frames, option);
    // Written so that a NaN is missing.
    if (!(range.first >= first && range.second <= last)) {
        const double missing = range.second > last ? range.second : range.first;
        throw InputError(fmt::format(
            "{}: {} has no frame {}; it has {}", option, out.cache.string(), missing,
            first == last ? fmt::format("frame {} alone", first)
                          : fmt::format("frames {} to {}", first, last)));
    }
    for (double f = range.first; f <= range.second; ++f) out.frames.push_back(f);
    return out;
}

namespace {

/// Brings `generator`'s binding to a frame, and says the guides and where they stand.
void pose_to(Generator& generator, const RestPlaces& rest, const ChosenFrames& chosen,
             const Job& job, double frame, FrameState& out) {
    out.guides = chosen.cache.empty() ? generator.source.guides
                                      : guides_at(chosen, rest, job, frame);
    if (!chosen.cache.empty() && job.pose_at) out.pose = job.pose_at(frame);
    out.scalp_roots = pose_binding(generator.binding, rest, out.pose);
}

/// visit(frame, guides) for frames spread over the whole cache; `generator`'s sample is
/// where it is then.
template <class Visit>
void each_measured_frame(Generator& generator, const ChosenFrames& chosen, const Job& job,
                         const Visit& visit) {
    constexpr int kMeasured = 13;
    // Measured on the children that stand for all of them, at any density.
    std::swap(generator.binding, generator.sample);
    const RestPlaces rest = rest_places(generator.binding, generator.source);
    const int n = std::min(kMeasured, chosen.info.frames);
    for (int i = 0; i < n; ++i) {
        const int frame =
            chosen.info.first_frame + (chosen.info.frames - 1) * i / std::max(n - 1, 1);
        FrameState state;
        pose_to(generator, rest, chosen, job, frame, state);
        visit(frame, state.guides);
    }
    pose_binding(generator.binding, rest, RigidPose{});
    std::swap(generator.binding, generator.sample);
}

}  // namespace

RestPlaces prepare_frames(Generator& generator, const ChosenFrames& chosen,
                          const Job& job) {
    if (chosen.cache.empty() || chosen.info.frames < 2 || job.groom.intervals) {
        return rest_places(generator.binding, generator.source);
    }
    const Groom& groom = job.groom;
    int intervals = generator.profiles.count;
    each_measured_frame(generator, chosen, job, [&](int frame, const Guides& guides) {
        try {
            intervals = std::max(
                intervals, intervals_within(generator.binding, guides, groom.expand.blend,
                                            groom.tolerance, groom.expand.basis));
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: frame {}: {}", chosen.cache.string(), frame,
                                         error.what()));
        }
    });
    if (intervals != generator.profiles.count) {
        generator.profiles = guide_profiles<float>(generator.source.guides, intervals);
    }
    generator.classes = {{intervals}};
    if (groom.adapts()) {
        StrandClasses all = coarsest_classes(generator.source.guides, intervals);
        const auto refine = [&](const Binding& sample, const Guides& guides) {
            refine_classes(all, sample, guides, groom.tolerance, groom.expand);
        };
        refine(generator.sample, generator.source.guides);
        each_measured_frame(generator, chosen, job, [&](int, const Guides& guides) {
            refine(generator.binding, guides);
        });
        generator.classes = used_classes(all);
    }
    generator.binding = in_class_order(std::move(generator.binding), generator.classes);
    return rest_places(generator.binding, generator.source);
}

Guides guides_at(const ChosenFrames& chosen, const RestPlaces& rest, const Job& job,
                 double frame) {
    const auto read = [&](int f) {
        return read_guide_cache(chosen.cache, f - chosen.first());
    };
    const int whole = int(std::floor(frame));
    const double share = frame - whole;
    if (share == 0) return read(whole);
    const Guides from = read(whole), to = read(whole + 1);
    std::optional<Guides> before, after;
    if (whole > chosen.first()) before = read(whole - 1);
    if (whole + 1 < chosen.last()) after = read(whole + 2);
    const GuideKeys keys{&from, &to, before ? &*before : nullptr,
                         after ? &*after : nullptr};
    if (!job.pose_at) return guides_between(keys, share);
    const auto carriers_at = [&](double f) {
        return carriers(job.pose_at(f), rest.guide_places, from.size());
    };
    RootCarriers roots{
        carriers_at(whole), carriers_at(whole + 1), {}, {}, carriers_at(frame)};
    if (before) roots.before = carriers_at(whole - 1);
    if (after) roots.after = carriers_at(whole + 2);
    return guides_between(keys, share, InTime::frames, &roots);
}

FrameState go_to_frame(Generator& generator, const RestPlaces& rest,
                       const ChosenFrames& chosen, const Job& job, double frame) {
    FrameState out;
    pose_to(generator, rest, chosen, job, frame, out);
    out.classed =
        classed_guides(out.guides, generator.classes, generator.binding.guide_normals,
                       generator.groom.expand.blend);
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

/// The number with at least `width` characters before its decimals, if any.
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
    // %4d pads with blanks in C; a file's name is better off with zeros.
    return output.parent_path() /
           (found.prefix().str() + padded(frame, width) + found.suffix().str());
}

}  // namespace lancret
