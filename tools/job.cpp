#include "tools/job.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "guides/base/errors.h"
#include "procedural/curves/control_points.h"
#include "procedural/groom/head_pose.h"
#include "tools/options.h"
#include "tools/quiet_stderr.h"

namespace lancret {

namespace {

/// The options as overrides of the groom's file.
std::vector<GroomParameter> parameters_of(const GroomOptions& options) {
    std::vector<GroomParameter> out;
    const auto number = [&](const char* name, const auto& value) {
        if (value) out.push_back({name, std::nullopt, double(*value)});
    };
    const auto text = [&](const char* name, const std::string& value) {
        if (!value.empty()) out.push_back({name, value, 0});
    };
    if (!options.scalp.empty()) {
        // Paths in a groom start from its folder, those of an option from the working
        // directory.
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

/// Options that would change guides cannot apply to guides that a cache holds.
void refuse_guide_options(const GroomOptions& options, const GroomSettings& groom) {
    const bool cached = !groom.guides_file.empty();
    if (!cached && groom.strands_file.extension() != ".h5") return;
    const auto refuse = [&](const char* option) {
        throw InputError(
            fmt::format("{}: cannot change the guides in {}; fit new ones", option,
                        (cached ? groom.guides_file : groom.strands_file).string()));
    };
    if (!options.guides.empty()) refuse("--guides");
    if (options.segments) refuse("--segments");
    if (!options.basis.empty()) refuse("--basis");
}

}  // namespace

Job read_job(const GroomOptions& options) {
    Job job;
    job.source.path = options.input;
    job.source.parameters = parameters_of(options);
    SourcedGroom sourced = read_groom_source(job.source);
    job.groom = std::move(sourced.groom);
    if (std::filesystem::path(job.groom.name).extension() == ".toml") {
        const QuietStderr quiet;  // a texture's error is thrown by its reader as well
        job.preview =
            read_preview_settings(sourced.toml, job.groom.scene.up.cast<float>());
        job.dynamics =
            read_dynamics(sourced.toml, job.groom.scene, std::move(sourced.motion));
    }
    sourced.toml.finish();
    job.settings_text = std::move(sourced.text);
    job.pose_at = head_pose(job.dynamics.motion, job.groom);
    refuse_guide_options(options, job.groom);
    job.inputs = {options.input, job.groom.strands_file, job.groom.guides_file,
                  job.groom.scalp_file};
    return job;
}

void check_points(const GroomSettings& groom, std::uint64_t strands, int intervals,
                  std::uint64_t points) {
    if (points <= std::numeric_limits<std::uint32_t>::max()) return;
    throw InputError(fmt::format(
        "{}: {} strands of {} intervals have {} points, more than the maximum of 2^32; "
        "use fewer strands (--strands) or intervals (--intervals)",
        groom.name, strands, intervals, points));
}

void check_points(const GroomSettings& groom) {
    const std::uint64_t strands = groom.strands.value_or(1);
    const int intervals = groom.intervals.value_or(1);
    check_points(
        groom, strands, intervals,
        strands * control_points_of(groom.expand.basis, std::uint32_t(intervals)));
}

}  // namespace lancret
