#pragma once
// The subcommands of lancret and their exit codes.

#include <CLI/CLI.hpp>

namespace lancret {

/// Exit codes of every subcommand.
enum ExitCode { kFine = 0, kCheckFailed = 1, kBadInput = 2 };

/// Each adds its subcommand to `app`. The work runs when the subcommand is chosen and
/// stores its exit code in `exit_code`.
void add_preview(CLI::App& app, int& exit_code);
void add_expand(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_evaluate(CLI::App& app, int& exit_code);
void add_fit(CLI::App& app, int& exit_code);
void add_simulate(CLI::App& app, int& exit_code);
void add_info(CLI::App& app, int& exit_code);
void add_rod(CLI::App& app, int& exit_code);

}  // namespace lancret
