#include "tools/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "guides/errors.h"
#include "tools/progress.h"

namespace lancret {

namespace {

std::vector<std::string> blend_names() {
    std::vector<std::string> out;
    for (const BlendName& entry : kBlendNames) out.emplace_back(entry.name);
    return out;
}

/// The groom that a file of strands or guides is by itself.
Groom groom_of_file(const std::filesystem::path& file) {
    Groom out;
    out.name = file.string();
    out.strands_file = file;
    return out;
}

void lay_over(const GroomOptions& options, Groom& groom) {
    if (!options.scalp.empty()) groom.scalp_file = options.scalp;
    if (!options.guides.empty())
        groom.guides = parse_guide_count(options.guides, "--guides");
    if (!options.blend.empty()) groom.expand.blend = *blend_named(options.blend);
    if (options.basis == "bspline") groom.basis = Basis::bspline;
    if (options.basis == "catmull-rom") groom.basis = Basis::catmull_rom;
    if (options.strands) groom.strands = *options.strands;
    if (options.segments) groom.fit.segments = *options.segments;
    if (options.intervals) groom.intervals = *options.intervals;
    if (options.seed) groom.seed = *options.seed;
}

}  // namespace

void add_groom_options(CLI::App& command, GroomOptions& options) {
    command
        .add_option("groom", options.input,
                    "a groom (.toml), strands (.hair) or guides (.h5)")
        ->required()
        ->type_name("FILE");
    command.add_option("--scalp", options.scalp, "mesh that the hair grows on")
        ->type_name("OBJ");
    command
        .add_option("--guides", options.guides,
                    "how many of the groom's strands become guides")
        ->type_name("N|P%");
    command.add_option("--strands", options.strands, "children to grow")
        ->type_name("N")
        ->check(CLI::Range(1u, 100'000'000u));
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
    command.add_option("--seed", options.seed, "of all that is drawn by chance")
        ->type_name("N");
    command
        .add_option("--stats", options.stats, "write what was done and how long it took")
        ->type_name("JSON");
}

Job read_job(const GroomOptions& options) {
    Job job;
    const std::string extension = options.input.extension().string();
    if (extension == ".toml") {
        const TomlTable toml = TomlTable::from_file(options.input);
        job.groom = read_groom(toml, options.input.string());
        job.preview = read_preview_settings(toml, job.groom.scene.up.cast<float>());
        toml.finish();
    } else if (extension == ".hair" || extension == ".h5") {
        job.groom = groom_of_file(options.input);
    } else {
        throw InputError(fmt::format("{}: a groom is a .toml, .hair or .h5 file",
                                     options.input.string()));
    }
    lay_over(options, job.groom);
    return job;
}

Generator run_generator(const Groom& groom) {
    StageLine line;
    Generator out = make_generator(groom, [&](const char* stage) { line.show(stage); });
    line.clear();
    for (const std::string& warning : out.source.warnings) {
        fmt::print(stderr, "lancret: warning: {}\n", warning);
    }
    if (out.source.snapped_roots > 0) {
        fmt::print(
            stderr,
            "lancret: {} of {} guide roots were off the scalp and were put on it; the "
            "farthest moved {:.3f} cm\n",
            out.source.snapped_roots, out.source.guides.size(), out.source.largest_snap);
    }
    if (out.binding.report.nearest_guide > 0) {
        fmt::print(stderr,
                   "lancret: {} of {} children face none of their guides and follow the "
                   "nearest\n",
                   out.binding.report.nearest_guide, out.binding.size());
    }
    return out;
}

std::pair<int, int> parse_size(const std::string& text) {
    int width = 0, height = 0, used = 0;
    const int fields = std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used);
    if (fields != 2 || std::size_t(used) != text.size() || width < 1 || height < 1 ||
        width > 16384 || height > 16384) {
        throw InputError(
            fmt::format("--size: '{}' is no size; give one such as 1280x720", text));
    }
    return {width, height};
}

}  // namespace lancret
