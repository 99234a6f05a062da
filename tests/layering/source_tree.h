#pragma once
// The project's sources as text, for rules that read them.

#include <string>
#include <string_view>
#include <vector>

namespace lancret::layering {

struct SourceFile {
    std::string path;  ///< from the project's root
    std::string text;
};

/// All .h, .inl and .cpp files of the product, the tests and the benchmarks, read once.
const std::vector<SourceFile>& source_tree();

/// One #include.
struct Include {
    std::string file;  ///< that contains it, from the root
    std::string name;  ///< of the header, as written
    bool quoted;       ///< "..." instead of <...>
};

/// The includes in `text`, the contents of `file`, in order.
std::vector<Include> includes_in(const std::string& file, const std::string& text);

/// A function with a body.
struct Function {
    std::string file, name;
    std::size_t line;   ///< where it begins, from 1
    std::size_t lines;  ///< from there to its closing brace
};

/// The functions in `text` as clang-format lays them out: a line in the first column that
/// opens a brace at its end or in the lines after it, up to a closing brace in the first
/// column.
std::vector<Function> functions_in(const std::string& file, const std::string& text);

/// The lines of `text`, from 1, on which a condition or a loop ends without a brace, so
/// that its body stands bare on the next line. A body on the same line needs none.
std::vector<std::size_t> bare_bodies_in(const std::string& text);

std::string folder_of(std::string_view path);  ///< without the file's name
std::string top_of(std::string_view path);     ///< the first folder

/// Whether `text` begins with one of `starts`, which are separated by spaces.
bool begins_with_any(std::string_view text, std::string_view starts);

}  // namespace lancret::layering
