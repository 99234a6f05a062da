#pragma once
// Overrides: values of a parsed document that do not come from its file. Callers can
// only pass numbers and texts.

#include <toml++/toml.h>

#include <cstdint>
#include <optional>

namespace lancret {

bool is_override(const toml::node& value);

/// The boolean of an override that is 0 or 1; nullopt otherwise.
std::optional<bool> override_bit(const toml::node& value);

/// The seed of an override that is a text: a double cannot hold every seed. nullopt
/// otherwise.
std::optional<std::uint64_t> override_seed(const toml::node& value);

}  // namespace lancret
