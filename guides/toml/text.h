#pragma once
// The text of a TOML, before it is read.

#include <filesystem>
#include <string>
#include <string_view>

namespace lancret {

/// What is in a file. Throws InputError.
std::string toml_file_text(const std::filesystem::path& path);

/// Most dots in a name, and most brackets and braces one in another: the library's tables
/// end by recursion, and it sets a limit to values alone.
inline constexpr int kMaxTomlDots = 16, kMaxTomlBrackets = 16;

/// Throws InputError "<name>:<line>: ..." where the text goes deeper.
void check_toml_depth(std::string_view text, const std::string& name);

}  // namespace lancret
