#include "tools/command.h"

#include <fmt/format.h>

#include "guides/errors.h"
#include "tools/progress.h"

namespace lancret {

void add_groom_options(CLI::App& command, GroomOptions& options) {
    command
        .add_option("groom", options.input, "a groom (.toml), strands (.hair) or guides (.h5)")
        ->required()
        ->type_name("FILE");
    command.add_option("--scalp", options.scalp, "mesh the hair grows on")->type_name("OBJ");
    command
        .add_option("--guides", options.guides,
                    "how many of the groom's strands become guides")
        ->type_name("N|P%");
    command.add_option("--strands", options.strands, "children to grow")->type_name("N");
    command.add_option("--blend", options.blend, "option1 or position")->type_name("NAME");
    command.add_option("--basis", options.basis, "what .hair points are: catmull-rom or bspline")
        ->type_name("NAME");
    command.add_option("--segments", options.segments, "helices of a guide")->type_name("N");
    command.add_option("--intervals", options.intervals, "curve segments of a child")
        ->type_name("N");
    command.add_option("--seed", options.seed, "of all that is drawn by chance")->type_name("N");
    command.add_option("--stats", options.stats, "write what was done and how long it took")
        ->type_name("JSON");
    command.add_option("--threads", options.threads, "at most so many; 0 for all")
        ->type_name("N")
        ->check(CLI::Range(0, 1024));
}

namespace {

/// The options as one more TOML text, read like the groom's own: one set of names and ranges.
std::string as_toml(const GroomOptions& options) {
    std::string guides = "[guides]\n", strands = "[strands]\n";
    if (!options.basis.empty()) guides += fmt::format("basis = '{}'\n", options.basis);
    if (options.segments) guides += fmt::format("segments = {}\n", *options.segments);
    if (options.strands) strands += fmt::format("count = {}\n", *options.strands);
    if (!options.blend.empty()) strands += fmt::format("blend = '{}'\n", options.blend);
    if (options.intervals) strands += fmt::format("intervals = {}\n", *options.intervals);
    if (options.seed) strands += fmt::format("seed = {}\n", *options.seed);
    return guides + strands;
}

}  // namespace

}  // namespace lancret
