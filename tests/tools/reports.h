#pragma once
// Reports of a command, and how it ended.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/tools/command_run.h"

namespace lancret {

inline nlohmann::json json_of(const std::string& file) {
    return nlohmann::json::parse(read_bytes(file));
}

/// Matches a run with exit code 0.
inline auto works() { return testing::Field("exit code", &CommandRun::exit_code, 0); }

}  // namespace lancret
