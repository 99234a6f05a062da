#pragma once
// The state in a guide cache that continues its run after the last frame.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lancret {

/// Named arrays of finite numbers. A name has at least one character, contains no '/' and
/// is not ".".
using RestartArrays = std::map<std::string, std::vector<double>>;

/// What a run needs besides the guides of its last frame to continue.
struct Restart {
    std::string job;  ///< identifies the run: groom, guides and settings
    RestartArrays arrays;
};

/// Reads it from a cache. Throws InputError if it is missing or damaged.
Restart read_restart(const std::filesystem::path& path);

}  // namespace lancret
