// The lancret command: grows hair between guides, shows it and proves it.

#include <fmt/format.h>

#include <new>

#include "guides/errors.h"
#include "tools/command.h"

int main(int argc, char** argv) {
    using namespace lancret;
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
    add_fit(app, exit_code);
    add_info(app, exit_code);
    try {
        app.parse(argc, argv);
        return exit_code;
    } catch (const CLI::Success& asked_for_help) {
        return app.exit(asked_for_help);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "lancret: {} (see --help)\n", error.what());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "lancret: not enough memory\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "lancret: {}\n", error.what());
    }
    return kBadInput;
}
