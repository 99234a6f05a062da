// The lancret command.

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

/// Prints an error as one line, even if a library's message has several.
void print_error(std::string what) {
    for (char& c : what) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    what.erase(what.find_last_not_of(' ') + 1);
    fmt::print(stderr, "lancret: {}\n", what);
}

/// Throws InputError if `word` is neither an option nor a subcommand.
void check_subcommand(const CLI::App& app, std::string_view word) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    if (word.starts_with('-') || std::ranges::find(names, word) != names.end()) return;
    const auto nearest =
        nearest_name(word, std::vector<std::string_view>(names.begin(), names.end()));
    throw InputError(
        fmt::format("unknown subcommand '{}'{}; expected one of {} (see --help)", word,
                    nearest ? fmt::format(", did you mean '{}'?", *nearest) : "",
                    fmt::join(names, ", ")));
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Grows hair between Super-Helix guides, renders and checks it.",
                 "lancret");
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 success, 1 a check failed, 2 invalid input or usage.\n"
        "`lancret COMMAND --help` shows examples.");
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
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        print_error(fmt::format("{} (see --help)", error.what()));
    } catch (const std::bad_alloc&) {
        print_error("not enough memory for this many strands or pixels");
    } catch (const std::exception& error) {
        print_error(error.what());
    }
    return kBadInput;
}
