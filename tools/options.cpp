#include "tools/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <limits>
#include <vector>

#include "guides/base/atomic_file.h"
#include "guides/base/errors.h"
#include "procedural/blend/blend.h"
#include "procedural/roots/density.h"

namespace lancret {

namespace {

std::vector<std::string> blend_names() {
    std::vector<std::string> out;
    for (const BlendTraits& entry : blends()) out.emplace_back(entry.name);
    return out;
}

/// `text` as a whole number of type T; nullopt if any of it is not part of one.
template <class T>
std::optional<T> whole_number(std::string_view text) {
    T value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

/// `text` as a number in [low, high]; nullopt if it is none, or NaN.
std::optional<double> number_in(const std::string& text, double low, double high) {
    double value = 0;
    if (!CLI::detail::lexical_cast(text, value)) return std::nullopt;
    if (!(value >= low && value <= high)) return std::nullopt;
    return value;
}

}  // namespace

void add_groom_options(CLI::App& command, GroomOptions& options) {
    command
        .add_option("groom", options.input,
                    "a groom (.toml), strands (.hair) or guides (.h5)")
        ->required()
        ->type_name("FILE")
        ->check(not_empty());
    command.add_option("--scalp", options.scalp, "mesh that the hair grows on")
        ->type_name("OBJ")
        ->check(not_empty());
    command
        .add_option("--guides", options.guides,
                    "number or percentage of the groom's strands that become guides")
        ->type_name("N|P%")
        ->check(not_empty());
    command.add_option("--strands", options.strands, "number of child strands")
        ->type_name("N")
        ->check(CLI::Range(1u, 100'000'000u));
    command
        .add_option("--density", options.density,
                    "fraction of the children to grow, 0 to 1; fewer strands are drawn "
                    "wider")
        ->type_name("D")
        ->check(number_between(kMinDensity, 1.0));
    command.add_option("--blend", options.blend, "how guides are blended into children")
        ->type_name("NAME")
        ->check(CLI::IsMember(blend_names()));
    command
        .add_option("--basis", options.basis,
                    "interpretation of the points in a .hair file")
        ->type_name("NAME")
        ->check(CLI::IsMember({"catmull-rom", "bspline"}));
    command.add_option("--segments", options.segments, "helices per guide")
        ->type_name("N")
        ->check(CLI::Range(1, 200));
    command.add_option("--intervals", options.intervals, "curve segments per child")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    command.add_flag("--no-adapt", options.no_adapt,
                     "use the finest interval count for every strand");
    command.add_option("--seed", options.seed, "random seed")
        ->type_name("N")
        ->check(seed_number());
    command.add_option("--stats", options.stats, "write statistics and timings")
        ->type_name("JSON")
        ->check(not_empty());
}

CLI::Validator not_empty() {
    return {[](const std::string& text) {
                return std::string(text.empty() ? "must not be empty" : "");
            },
            ""};
}

CLI::Validator number_between(double low, double high) {
    return {[low, high](const std::string& text) {
                if (number_in(text, low, high)) return std::string();
                return fmt::format("'{}': expected a number from {} to {}", text, low,
                                   high);
            },
            fmt::format("{} to {}", low, high)};
}

CLI::Validator not_negative() {
    return {[](const std::string& text) {
                const double any = std::numeric_limits<double>::infinity();
                if (number_in(text, 0, any)) return std::string();
                return fmt::format("'{}': expected a number of at least 0", text);
            },
            ""};
}

CLI::Validator seed_number() {
    return {[](const std::string& text) {
                if (whole_number<std::uint64_t>(text)) return std::string();
                return fmt::format(
                    "invalid seed '{}': expected a whole number from 0 to {}", text,
                    std::numeric_limits<std::uint64_t>::max());
            },
            ""};
}

std::pair<int, int> parse_size(const std::string& text) {
    const std::string_view all = text;
    const std::size_t by = std::min(all.find('x'), all.size());
    const auto width = whole_number<int>(all.substr(0, by));
    const auto height = whole_number<int>(all.substr(std::min(by + 1, all.size())));
    constexpr int kMaxSide = 16384;
    if (!width || !height || *width < 1 || *height < 1 || *width > kMaxSide ||
        *height > kMaxSide) {
        throw InputError(
            fmt::format("--size: invalid size '{}': expected WIDTHxHEIGHT, such as "
                        "1280x720, each at most {}",
                        text, kMaxSide));
    }
    return {*width, *height};
}

void check_output(const std::filesystem::path& output,
                  std::initializer_list<std::string_view> extensions,
                  std::span<const std::filesystem::path> inputs,
                  const std::filesystem::path& other) {
    if (output.empty()) return;
    if (!other.empty() && std::filesystem::absolute(output).lexically_normal() ==
                              std::filesystem::absolute(other).lexically_normal()) {
        throw InputError(fmt::format("{}: cannot hold two outputs", output.string()));
    }
    const std::string extension = output.extension().string();
    if (extensions.size() > 0 &&
        std::ranges::find(extensions, extension) == extensions.end()) {
        throw InputError(fmt::format("{}: expected a file name that ends in {}",
                                     output.string(), fmt::join(extensions, " or ")));
    }
    for (const std::filesystem::path& input : inputs) {
        std::error_code missing;  // a missing input is reported when it is read
        if (std::filesystem::equivalent(output, input, missing)) {
            throw InputError(
                fmt::format("{}: is an input of the groom; give the output another name",
                            output.string()));
        }
    }
    const PendingFile file(output);
    errno = 0;
    if (!std::ofstream(file.temporary())) {
        throw InputError(fmt::format("{}: cannot be written: {}", output.string(),
                                     errno ? std::strerror(errno) : "unknown error"));
    }
}

}  // namespace lancret
