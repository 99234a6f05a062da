#pragma once
// Command-line options that several subcommands share, and the checks of their values.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace lancret {

/// Options of every subcommand that grows strands.
struct GroomOptions {
    std::filesystem::path input;
    std::string scalp, guides, blend, basis;
    std::optional<std::uint32_t> strands;
    std::optional<int> segments, intervals;
    std::optional<std::uint64_t> seed;
    std::optional<double> density;
    bool no_adapt = false;
    std::string stats;  ///< path of a JSON file; empty: none
};

void add_groom_options(CLI::App& command, GroomOptions& options);

/// Accepts a value that is not empty, as that of an unset shell variable would be.
CLI::Validator not_empty();

/// Accepts a number in [low, high]; rejects NaN.
CLI::Validator number_between(double low, double high);

/// Accepts a number >= 0; rejects NaN.
CLI::Validator not_negative();

/// Accepts a random seed: a whole number of 64 bits.
CLI::Validator seed_number();

/// Width and height of "1280x720". Throws InputError.
std::pair<int, int> parse_size(const std::string& text);

/// Fails early if `output` cannot be written: its extension must be one of `extensions`
/// (any if empty), its folder must accept a new file, and it must be neither one of the
/// `inputs` nor the `other` output. No-op if `output` is empty. Throws InputError.
void check_output(const std::filesystem::path& output,
                  std::initializer_list<std::string_view> extensions,
                  std::span<const std::filesystem::path> inputs = {},
                  const std::filesystem::path& other = {});

}  // namespace lancret
