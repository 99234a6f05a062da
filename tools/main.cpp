// The lancret command: grows hair between guides, shows it and proves it.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "guides/base/errors.h"
#include "guides/toml/table.h"
#include "tools/subcommands.h"

using namespace lancret;

namespace {

/// Exactly one line on stderr, whatever a library put into its message.
void complain(std::string what) {
    for (char& c : what) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    what.erase(what.find_last_not_of(' ') + 1);
    fmt::print(stderr, "lancret: {}\n", what);
}

/// A word in the place of a subcommand that is none.
void check_subcommand(const CLI::App& app, std::string_view word) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    if (word.starts_with('-') || std::ranges::find(names, word) != names.end()) return;
    const auto meant =
        nearest_name(word, std::vector<std::string_view>(names.begin(), names.end()));
    throw InputError(fmt::format("there is no subcommand '{}'{}; one of: {} (see --help)",
                                 word,
                                 meant ? fmt::format(", did you mean '{}'?", *meant) : "",
                                 fmt::join(names, ", ")));
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Grows hair between Super-Helix guides, shows it and proves it.",
                 "lancret");
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 fine, 1 a check failed, 2 bad input or use.\n"
        "`lancret COMMAND --help` has examples.");
    int exit_code = kFine;
    add_preview(app, exit_code);
    add_expand(app, exit_code);
    add_check(app, exit_code);
    add_evaluate(app, exit_code);
    add_fit(app, exit_code);
    add_simulate(app, exit_code);
    add_info(app, exit_code);
    add_rod(app, exit_code);
    try {
        if (argc > 1) check_subcommand(app, argv[1]);
        app.parse(argc, argv);
        return exit_code;
    } catch (const CLI::Success& asked_for_help) {
        return app.exit(asked_for_help);
    } catch (const CLI::ParseError& error) {
        complain(fmt::format("{} (see --help)", error.what()));
    } catch (const std::bad_alloc&) {
        complain("not enough memory for this many strands or pixels");
    } catch (const std::exception& error) {
        complain(error.what());
    }
    return kBadInput;
}
