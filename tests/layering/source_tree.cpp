#include "tests/layering/source_tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "tests/layering/layers.h"

namespace lancret::layering {

namespace {

const std::filesystem::path kRoot = LANCRET_SOURCE_DIR;

std::string read(const std::filesystem::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Whether a line in the first column may begin a function: not a comment, a macro or a
/// closing brace, nor the start of a type, a namespace or a variable.
bool may_begin_function(const std::string& line) {
    if (line.empty() ||
        std::string_view(" }#/)").find(line[0]) != std::string_view::npos) {
        return false;
    }
    static const std::regex kOther(
        "^(namespace|struct|class|enum|union|extern|using|typedef|template|inline "
        "constexpr|constexpr [a-zA-Z0-9_:<>]+ "
        "k[A-Z]|const [a-zA-Z0-9_:<>]+ k[A-Z]).*");
    return !std::regex_match(line, kOther);
}

}  // namespace

const std::vector<SourceFile>& source_tree() {
    static const std::vector<SourceFile> files = [] {
        std::vector<SourceFile> out;
        const auto add = [&](std::string_view top) {
            for (const auto& entry :
                 std::filesystem::recursive_directory_iterator(kRoot / top)) {
                const std::string kind = entry.path().extension().string();
                if (kind != ".h" && kind != ".cpp" && kind != ".inl") continue;
                out.push_back({entry.path().lexically_relative(kRoot).generic_string(),
                               read(entry.path())});
            }
        };
        for (const std::string_view top : kTops) add(top);
        for (const std::string_view top : kTestTops) add(top);
        std::ranges::sort(out, {}, &SourceFile::path);
        return out;
    }();
    return files;
}

std::vector<Include> includes_in(const std::string& file, const std::string& text) {
    static const std::regex kInclude(
        R"re((^|\n)[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+))re");
    std::vector<Include> out;
    for (std::sregex_iterator at(text.begin(), text.end(), kInclude), end; at != end;
         ++at) {
        out.push_back({file, (*at)[3], (*at)[2] == "\""});
    }
    return out;
}

std::vector<Function> functions_in(const std::string& file, const std::string& text) {
    std::vector<Function> out;
    std::istringstream stream(text);
    std::string line, name;
    std::size_t number = 0, begin = 0;
    bool body = false;
    while (std::getline(stream, line)) {
        ++number;
        if (begin == 0 && may_begin_function(line)) {
            begin = number;
            name = line;
            body = false;
        }
        if (begin == 0) continue;
        if (line.ends_with("{")) body = true;
        if (!body && line.ends_with(";")) begin = 0;  // a declaration
        if (body && line.starts_with("}")) {
            out.push_back({file, name, begin, number - begin + 1});
            begin = 0;
        } else if (!body && line.ends_with("}")) {
            begin = 0;  // on one line
        }
    }
    return out;
}

std::vector<std::size_t> bare_bodies_in(const std::string& text) {
    static const std::regex kKeyword(R"re(\s*(\} )?(if|for|while|else)\b.*)re");
    static const std::regex kLiterals(R"re("(\\.|[^"\\])*"|'(\\.|[^'\\])'|//.*)re");
    std::vector<std::size_t> out;
    std::istringstream stream(text);
    std::string line;
    std::ptrdiff_t open = 0;
    bool condition = false;
    for (std::size_t number = 1; std::getline(stream, line); ++number) {
        if (!condition && !std::regex_match(line, kKeyword)) continue;
        std::string code = std::regex_replace(line, kLiterals, "");
        code.erase(code.find_last_not_of(' ') + 1);
        open += std::ranges::count(code, '(') - std::ranges::count(code, ')');
        condition = open > 0;
        if (!condition && (code.ends_with(")") || code.ends_with("else"))) {
            out.push_back(number);
        }
        if (!condition) open = 0;
    }
    return out;
}

std::string folder_of(std::string_view path) {
    return std::string(path.substr(0, path.rfind('/')));
}

std::string top_of(std::string_view path) {
    return std::string(path.substr(0, path.find('/')));
}

bool begins_with_any(std::string_view text, std::string_view starts) {
    std::istringstream stream{std::string(starts)};
    for (std::string start; stream >> start;) {
        if (text.starts_with(start)) return true;
    }
    return false;
}

}  // namespace lancret::layering
