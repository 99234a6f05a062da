#pragma once
// What the subcommands share.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "procedural/groom/groom_source.h"
#include "procedural/motion/posed_binding.h"
#include "render_test/settings/preview.h"
#include "tools/dynamics_settings.h"

namespace lancret {

/// Exit codes of every subcommand.
enum ExitCode { kFine = 0, kCheckFailed = 1, kBadInput = 2 };

/// Options of every subcommand that grows strands.
struct GroomOptions {
    std::filesystem::path input;
    std::string scalp, guides, blend, basis;
    std::optional<std::uint32_t> strands;
    std::optional<int> segments, intervals;
    std::optional<std::uint64_t> seed;
    std::optional<double> density;
    bool no_adapt = false;
    std::string stats;  ///< JSON file; empty: none
};

void add_groom_options(CLI::App& command, GroomOptions& options);

/// A groom and how to look at it.
struct Job {
    GroomSource source;  ///< what the groom was read from, options and all
    GroomSettings groom;
    PreviewSettings preview;
    DynamicsSettings dynamics;
    std::string settings_text;  ///< of the TOML; empty where there is none
    ScalpPoseAt pose_at;        ///< none: the scalp stays at rest
};

/// Reads GROOM.toml, FILE.hair or GUIDES.h5 and lays the options over it. Throws
/// InputError.
Job read_job(const GroomOptions& options);

/// Finds out, before any work, what cannot be written: `output` must have one of
/// `extensions` (any, where there are none), its folder must take a file, and it must not
/// be a file that the job reads, nor the `other` output. An empty path is none. Throws
/// InputError.
void check_output(const std::filesystem::path& output,
                  std::initializer_list<std::string_view> extensions,
                  const GroomOptions& options, const GroomSettings& groom,
                  const std::filesystem::path& other = {});

/// For an option whose value must not be empty, as that of an unset shell variable is.
CLI::Validator not_empty();

/// For an option whose value is a number from `low` to `high`; NaN is none.
CLI::Validator between(double low, double high);

/// For an option whose value is a seed: what is wrong with `text`, empty where nothing
/// is.
std::string is_seed(const std::string& text);

/// Throws InputError where strands have more control points than 32 bits can count; the
/// second before any work, by what the groom asks for.
void check_points(const GroomSettings& groom, std::uint64_t strands, int intervals,
                  std::uint64_t points);
void check_points(const GroomSettings& groom);

/// "1280x720"; throws InputError.
std::pair<int, int> parse_size(const std::string& text);

/// Each subcommand adds itself to `app`; its work runs when it is chosen and leaves its
/// exit code in `exit_code`.
void add_preview(CLI::App& app, int& exit_code);
void add_expand(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_evaluate(CLI::App& app, int& exit_code);
void add_fit(CLI::App& app, int& exit_code);
void add_simulate(CLI::App& app, int& exit_code);
void add_info(CLI::App& app, int& exit_code);
void add_rod(CLI::App& app, int& exit_code);

}  // namespace lancret
