#pragma once
// Colours, directions, places and angles in a groom's TOML tables. All throw InputError.

#include <optional>

#include "guides/toml/table.h"

namespace lancret {

/// A colour: three numbers from 0 to `limit`.
std::optional<Vec3f> colour_value(const TomlTable& table, std::string_view key,
                                  double limit);

/// A direction: three numbers, not all zero; normalised.
std::optional<Vec3f> direction_value(const TomlTable& table, std::string_view key);

/// A position, cm.
std::optional<Vec3f> place_value(const TomlTable& table, std::string_view key);

/// An angle in degrees within [low, high], as radian.
std::optional<float> angle_value(const TomlTable& table, std::string_view key, double low,
                                 double high);

}  // namespace lancret
