#include "tools/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <limits>

#include "guides/base/atomic_file.h"
#include "guides/base/errors.h"
#include "procedural/roots/density.h"
#include "tools/quiet_stderr.h"

namespace lancret {

namespace {

std::vector<std::string> blend_names() {
    std::vector<std::string> out;
    for (const BlendName& entry : kBlendNames) out.emplace_back(entry.name);
    return out;
}

/// All of `text` as a whole number of type T, without a sign that T has not.
template <class T>
std::optional<T> whole_number(std::string_view text) {
    T value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

/// The options as values of the groom's file.
std::vector<GroomParameter> parameters_of(const GroomOptions& options) {
    std::vector<GroomParameter> out;
    const auto number = [&](const char* name, const auto& value) {
        if (value) out.push_back({name, std::nullopt, double(*value)});
    };
    const auto text = [&](const char* name, const std::string& value) {
        if (!value.empty()) out.push_back({name, value, 0});
    };
    if (!options.scalp.empty()) {
        // Files of a groom are found from its folder, those of an option from here.
        const std::filesystem::path scalp = options.scalp;
        const bool here = !options.input.has_parent_path();
        text("scalp.file", (here ? scalp : std::filesystem::absolute(scalp)).string());
    }
    if (!options.guides.empty()) {
        const GuideCount guides = parse_guide_count(options.guides, "--guides");
        number("guides.count", guides.number);
        number("guides.share", guides.share);
    }
    text("strands.blend", options.blend);
    text("guides.basis", options.basis);
    number("strands.count", options.strands);
    number("guides.segments", options.segments);
    number("strands.intervals", options.intervals);
    if (options.no_adapt) out.push_back({"strands.adapt", std::nullopt, 0});
    number("strands.density", options.density);
    if (options.seed) text("strands.seed", std::to_string(*options.seed));
    return out;
}

}  // namespace

void add_groom_options(CLI::App& command, GroomOptions& options) {
    command
        .add_option("groom", options.input,
                    "a groom (.toml), strands (.hair) or guides (.h5)")
        ->required()
        ->type_name("FILE")
        ->check(not_empty());
    command.add_option("--scalp", options.scalp, "mesh that the hair grows on")
        ->type_name("OBJ")
        ->check(not_empty());
    command
        .add_option("--guides", options.guides,
                    "how many of the groom's strands become guides")
        ->type_name("N|P%")
        ->check(not_empty());
    command.add_option("--strands", options.strands, "children to grow")
        ->type_name("N")
        ->check(CLI::Range(1u, 100'000'000u));
    command
        .add_option(
            "--density", options.density,
            "share of the children that are grown, 0 to 1, wider as they are fewer")
        ->type_name("D")
        ->check(between(kMinDensity, 1.0));
    command.add_option("--blend", options.blend, "how children are made of guides")
        ->type_name("NAME")
        ->check(CLI::IsMember(blend_names()));
    command.add_option("--basis", options.basis, "what the points of a .hair file are")
        ->type_name("NAME")
        ->check(CLI::IsMember({"catmull-rom", "bspline"}));
    command.add_option("--segments", options.segments, "helices of a guide")
        ->type_name("N")
        ->check(CLI::Range(1, 200));
    command.add_option("--intervals", options.intervals, "curve segments of a child")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    command.add_flag("--no-adapt", options.no_adapt,
                     "give all strands the intervals that the worst need");
    command.add_option("--seed", options.seed, "of all that is drawn by chance")
        ->type_name("N")
        ->check(is_seed);
    command
        .add_option("--stats", options.stats, "write what was done and how long it took")
        ->type_name("JSON")
        ->check(not_empty());
}

Job read_job(const GroomOptions& options) {
    Job job;
    job.source.path = options.input;
    job.source.parameters = parameters_of(options);
    job.groom = read_groom_source(job.source).groom;
    const std::filesystem::path toml_file = job.groom.name;
    if (toml_file.extension() == ".toml") {
        // Once more, for the tables that are not the groom's.
        const TomlTable toml = TomlTable::from_file(toml_file);
        for (const std::string_view key : kGroomTables) toml.leave(key);
        const QuietStderr quiet;  // the textures' errors are told by ours
        job.preview = read_preview_settings(toml, job.groom.scene.up.cast<float>());
        job.dynamics = read_dynamics(toml, job.groom.scene);
        toml.finish();
        std::ifstream file(toml_file, std::ios::binary);
        job.settings_text.assign(std::istreambuf_iterator<char>(file), {});
    }
    job.pose_at = head_pose(job.dynamics.motion, job.groom);
    const bool cached = !job.groom.guides_file.empty();
    if (cached || job.groom.strands_file.extension() == ".h5") {
        const auto refuse = [&](const char* option) {
            throw InputError(fmt::format(
                "{}: cannot change the guides that {} holds; fit new ones", option,
                (cached ? job.groom.guides_file : job.groom.strands_file).string()));
        };
        if (!options.guides.empty()) refuse("--guides");
        if (options.segments) refuse("--segments");
        if (!options.basis.empty()) refuse("--basis");
    }
    return job;
}

void check_output(const std::filesystem::path& output,
                  std::initializer_list<std::string_view> extensions,
                  const GroomOptions& options, const GroomSettings& groom,
                  const std::filesystem::path& other) {
    if (output.empty()) return;
    if (!other.empty() && std::filesystem::absolute(output).lexically_normal() ==
                              std::filesystem::absolute(other).lexically_normal()) {
        throw InputError(fmt::format("{}: cannot hold two outputs", output.string()));
    }
    const std::string extension = output.extension().string();
    if (extensions.size() > 0 &&
        std::ranges::find(extensions, extension) == extensions.end()) {
        throw InputError(fmt::format("{}: is written as {} only", output.string(),
                                     fmt::join(extensions, " or ")));
    }
    for (const auto& input :
         {options.input, groom.strands_file, groom.guides_file, groom.scalp_file}) {
        std::error_code missing;  // is no reason to complain here
        if (std::filesystem::equivalent(output, input, missing)) {
            throw InputError(fmt::format(
                "{}: is what the groom is read from; give the output another name",
                output.string()));
        }
    }
    const PendingFile file(output);
    errno = 0;
    if (!std::ofstream(file.temporary())) {
        throw InputError(fmt::format("{}: cannot be written: {}", output.string(),
                                     errno ? std::strerror(errno) : "no file there"));
    }
}

std::string is_seed(const std::string& text) {
    if (whole_number<std::uint64_t>(text)) return {};
    return fmt::format("'{}' is no seed; give a whole number from 0 to {}", text,
                       std::numeric_limits<std::uint64_t>::max());
}

CLI::Validator not_empty() {
    return {[](const std::string& text) {
                return std::string(text.empty() ? "must not be empty" : "");
            },
            ""};
}

CLI::Validator between(double low, double high) {
    return {[low, high](const std::string& text) -> std::string {
                double value = 0;
                // Written so that a NaN is outside.
                const bool good = CLI::detail::lexical_cast(text, value) &&
                                  value >= low && value <= high;
                return good ? std::string()
                            : fmt::format("'{}' is not from {} to {}", text, low, high);
            },
            fmt::format("{} to {}", low, high)};
}

void check_points(const GroomSettings& groom, std::uint64_t strands, int intervals,
                  std::uint64_t points) {
    if (points <= std::numeric_limits<std::uint32_t>::max()) return;
    throw InputError(fmt::format(
        "{}: {} strands of {} intervals have {} points, more than 2^32: ask for fewer by "
        "--strands or --intervals",
        groom.name, strands, intervals, points));
}

void check_points(const GroomSettings& groom) {
    const std::uint64_t asked = groom.strands.value_or(1);
    const int least = groom.intervals.value_or(1);
    check_points(groom, asked, least,
                 asked * control_points_of(groom.expand.basis, std::uint32_t(least)));
}

std::pair<int, int> parse_size(const std::string& text) {
    const std::string_view all = text;
    const std::size_t by = std::min(all.find('x'), all.size());
    const auto width = whole_number<int>(all.substr(0, by));
    const auto height = whole_number<int>(all.substr(std::min(by + 1, all.size())));
    constexpr int kMax = 16384;
    if (!width || !height || *width < 1 || *height < 1 || *width > kMax ||
        *height > kMax) {
        throw InputError(fmt::format(
            "--size: '{}' is no size; give one such as 1280x720, at most {} a side", text,
            kMax));
    }
    return {*width, *height};
}

}  // namespace lancret
