// lancret preview: renders a groom.

#include <memory>

#include "tools/preview/run.h"
#include "tools/stats.h"
#include "tools/subcommands.h"

namespace lancret {

void add_preview(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<PreviewOptions>();
    CLI::App* command = app.add_subcommand("preview", "Render a picture of a groom");
    add_preview_options(*command, *options);
    command->callback([options, &exit_code] {
        write_stats(options->groom.stats, run_preview(*options));
        exit_code = kFine;
    });
}

}  // namespace lancret
