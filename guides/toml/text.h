#pragma once
// The text of a TOML file before it is parsed.

#include <filesystem>
#include <string>
#include <string_view>

namespace lancret {

/// The contents of a file. Throws InputError.
std::string toml_file_text(const std::filesystem::path& path);

/// Maximum number of dots in a key, and of brackets and braces one inside another. The
/// parser's tables are destroyed by recursion, and it limits only the depth of values.
inline constexpr int kMaxTomlDots = 16, kMaxTomlBrackets = 16;

/// Throws InputError "<name>:<line>: ..." if the text exceeds them.
void check_toml_depth(std::string_view text, const std::string& name);

}  // namespace lancret
