#pragma once
// Colours, directions and places of a groom's TOML, for the readers of its tables.

#include <optional>

#include "guides/toml/table.h"

namespace lancret {

/// Takes over what is there.
template <class T, class U>
void set(T& to, const std::optional<U>& value) {
    if (value) to = T(*value);
}

/// A colour: three numbers, none negative, none above `most`. Throws InputError, as all
/// here.
std::optional<Vec3f> colour_value(const TomlTable& table, std::string_view key,
                                  double most);

/// A direction: three numbers, not all zero; of length one.
std::optional<Vec3f> direction_value(const TomlTable& table, std::string_view key);

/// A place, cm.
std::optional<Vec3f> place_value(const TomlTable& table, std::string_view key);

/// An angle in degrees within [low, high], as radian.
std::optional<float> angle_value(const TomlTable& table, std::string_view key, double low,
                                 double high);

}  // namespace lancret
