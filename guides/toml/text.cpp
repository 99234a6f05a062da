#include "guides/toml/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "guides/base/errors.h"

namespace lancret {

namespace {

/// The position after the string that begins at `at`, a quotation mark.
std::size_t behind_string(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const std::string three(3, quote);
    const bool lines = text.substr(at, 3) == three;
    at += lines ? 3 : 1;
    for (; at < text.size(); ++at) {
        if (text[at] == '\\' && quote == '"') {
            ++at;
        } else if (text[at] == quote && (!lines || text.substr(at, 3) == three)) {
            if (!lines) return at + 1;
            // The string itself may end with up to two more quotation marks.
            at += 3;
            for (int i = 0; i < 2 && at < text.size() && text[at] == quote; ++i) ++at;
            return at;
        }
    }
    return text.size();
}

}  // namespace

std::string toml_file_text(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw InputError(fmt::format("{}: is a folder, not a groom", path.string()));
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(fmt::format("{}: cannot be opened", path.string()));
    std::ostringstream text;
    if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
    if (file.bad() || text.fail()) {
        throw InputError(fmt::format("{}: cannot be read", path.string()));
    }
    return text.str();
}

void check_toml_depth(std::string_view text, const std::string& name) {
    const auto refuse = [&](std::size_t at, std::string_view what, int limit) {
        const auto line = 1 + std::count(text.begin(), text.begin() + long(at), '\n');
        throw InputError(
            fmt::format("{}:{}: {}, expected at most {}", name, line, what, limit));
    };
    int dots = 0, brackets = 0;
    for (std::size_t at = 0; at < text.size();) {
        const char letter = text[at];
        // Not a text file: the parser reports it and stops here.
        const bool space = letter == '\t' || letter == '\n' || letter == '\r';
        if (letter >= 0 && letter < ' ' && !space) return;
        if (letter == '"' || letter == '\'') {
            at = behind_string(text, at);
            continue;
        }
        if (letter == '#') {
            at = std::min(text.find('\n', at), text.size());
            continue;
        }
        if (letter == '.' && ++dots > kMaxTomlDots) {
            refuse(at, "a key has too many dots", kMaxTomlDots);
        }
        if (letter == '[' || letter == '{') {
            if (++brackets > kMaxTomlBrackets) {
                refuse(at, "values are nested too deeply", kMaxTomlBrackets);
            }
        }
        if ((letter == ']' || letter == '}') && brackets > 0) --brackets;
        if (std::string_view("=,[]{}").find(letter) != std::string_view::npos) dots = 0;
        ++at;
    }
}

}  // namespace lancret
