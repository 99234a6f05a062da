#pragma once
// How deep a TOML text goes, told before it is read: the library's tables end by
// recursion, and it sets a limit to values alone.

#include <string>
#include <string_view>

namespace lancret {

/// Most dots in a name, and most brackets and braces one in another.
inline constexpr int kMostTomlDots = 16, kMostTomlBrackets = 16;

/// Throws InputError "<name>:<line>: ..." where the text goes deeper.
void check_toml_depth(std::string_view text, const std::string& name);

}  // namespace lancret
