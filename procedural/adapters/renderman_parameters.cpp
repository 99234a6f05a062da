#include "procedural/adapters/renderman_parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace lancret {
namespace {

constexpr std::size_t kMaxTimes = 64;

/// A word of the string; `name` is empty if it has no '='.
struct Word {
    std::size_t character;  ///< position of its first character, from 1
    std::string name, value;
    bool quoted = false;
};

[[noreturn]] void fail(const Word& word, const std::string& what) {
    throw std::invalid_argument("character " + std::to_string(word.character) + ": " +
                                (word.name.empty() ? "" : word.name + ": ") + what);
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Reads the value at position `at` and moves `at` past it.
std::string value_at(std::string_view text, std::size_t& at, Word& word) {
    std::string out;
    const char quote = at < text.size() ? text[at] : ' ';
    if (quote != '"' && quote != '\'') {
        while (at < text.size() && !is_space(text[at])) out += text[at++];
        return out;
    }
    word.quoted = true;
    const std::size_t end = text.find(quote, ++at);
    if (end == std::string_view::npos) fail(word, "unterminated quotation");
    out = text.substr(at, end - at);
    at = end + 1;
    if (at < text.size() && !is_space(text[at])) {
        fail(word, "expected a space after the quotation");
    }
    return out;
}

std::vector<Word> words_of(std::string_view text) {
    std::vector<Word> out;
    for (std::size_t at = 0; at < text.size();) {
        if (is_space(text[at])) {
            ++at;
            continue;
        }
        Word word{at + 1, {}, {}};
        std::size_t name_end = at;
        while (name_end < text.size() && !is_space(text[name_end]) &&
               text[name_end] != '=' && text[name_end] != '"' && text[name_end] != '\'') {
            ++name_end;
        }
        if (name_end < text.size() && text[name_end] == '=') {
            word.name = text.substr(at, name_end - at);
            if (word.name.empty()) fail(word, "expected a name before '='");
            at = name_end + 1;
        }
        word.value = value_at(text, at, word);
        out.push_back(std::move(word));
    }
    return out;
}

bool read_number(std::string_view text, double& number) {
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() &&
           std::isfinite(number);
}

double number_of(const Word& word, double min, double max) {
    double out = 0;
    if (!read_number(word.value, out) || !(out >= min && out <= max)) {
        char range[96];
        std::snprintf(range, sizeof range, "expected a number in [%g, %g], not '", min,
                      max);
        fail(word, range + word.value + "'");
    }
    return out;
}

int integer_of(const Word& word, double min, double max) {
    const double out = number_of(word, min, max);
    if (out != std::floor(out)) fail(word, "expected a whole number");
    return int(out);
}

/// The comma-separated parts of a value.
std::vector<std::string> parts_of(const Word& word) {
    std::vector<std::string> out(1);
    for (const char c : word.value) {
        if (c == ',') {
            out.emplace_back();
        } else {
            out.back() += c;
        }
    }
    return out;
}

std::vector<double> numbers_of(const Word& word) {
    std::vector<double> out;
    for (const std::string& part : parts_of(word)) {
        Word part_word = word;
        part_word.value = part;
        out.push_back(number_of(part_word, -1e6, 1e6));
    }
    if (out.size() > kMaxTimes) fail(word, "expected at most 64 times");
    for (std::size_t i = 1; i < out.size(); ++i) {
        if (!(float(out[i]) > float(out[i - 1]))) fail(word, "expected increasing times");
    }
    return out;
}

struct Choice {
    const char* name;
    int value;
};
constexpr Choice kBases[] = {{"linear", LANCRET_LINEAR},
                             {"b-spline", LANCRET_BSPLINE},
                             {"catmull-rom", LANCRET_CATMULL_ROM},
                             {"bezier", LANCRET_BEZIER},
                             {"hermite", LANCRET_HERMITE}};
constexpr Choice kBounds[] = {{"reach", LANCRET_REACH}, {"tight", LANCRET_TIGHT}};
constexpr Choice kPrimvars[] = {
    {"N", LANCRET_NORMALS},     {"id", LANCRET_IDS},
    {"st", LANCRET_ROOT_UV},    {"length", LANCRET_LENGTHS},
    {"guides", LANCRET_GUIDES}, {"arc_length", LANCRET_ARC_LENGTHS},
    {"random", LANCRET_RANDOM}};

template <std::size_t n>
int choice_of(const Word& word, const std::string& name, const Choice (&choices)[n]) {
    std::string names;
    for (const Choice& choice : choices) {
        if (name == choice.name) return choice.value;
        names += (names.empty() ? "" : ", ") + std::string(choice.name);
    }
    fail(word, "expected one of " + names + ", not '" + name + "'");
}

GroomValue groom_value(const Word& word) {
    GroomValue out{word.name, {}};
    if (word.quoted) {
        out.is_text = true;
    } else if (word.value == "true" || word.value == "false") {
        out.number = word.value == "true";
    } else {
        out.is_text = !read_number(word.value, out.number);
    }
    if (out.is_text) out.text = word.value;
    return out;
}

/// The times, which several words set together.
struct Times {
    bool has_frame = false;
    double frame = 0;
    std::vector<double> samples, motion;
};

void take(const Word& word, RendermanParameters& out, Times& times) {
    const std::string& name = word.name;
    if (name.find('.') != std::string::npos) {
        out.values.push_back(groom_value(word));
    } else if (name.empty() || name == "file") {
        if (!out.file.empty()) {
            fail(word, "the file is already set to '" + out.file + "'");
        }
        if (word.value.empty()) fail(word, "expected a file name");
        out.file = word.value;
    } else if (name == "frame") {
        times.has_frame = true;
        times.frame = number_of(word, -1e6, 1e6);
    } else if (name == "samples") {
        times.samples = numbers_of(word);
    } else if (name == "motion") {
        times.motion = numbers_of(word);
    } else if (name == "basis") {
        out.basis = choice_of(word, word.value, kBases);
    } else if (name == "max_error") {
        out.max_error = float(number_of(word, 0, 1e6));
    } else if (name == "density") {
        out.density = number_of(word, 1e-6, 1);
    } else if (name == "strands_per_pixel") {
        out.strands_per_pixel = number_of(word, 0, 1e6);
    } else if (name == "min_density") {
        out.min_density = number_of(word, 1e-6, 1);
    } else if (name == "primvars") {
        for (const std::string& part : parts_of(word)) {
            out.attributes |= lancret_u32(choice_of(word, part, kPrimvars));
        }
    } else if (name == "chunk_strands") {
        out.chunk_strands = lancret_u32(integer_of(word, 1, 1'000'000));
    } else if (name == "unit") {
        out.unit = float(number_of(word, 1e-6, 1e9));
    } else if (name == "threads") {
        out.threads = integer_of(word, 0, 4096);
    } else if (name == "bound") {
        out.bound = choice_of(word, word.value, kBounds);
    } else {
        fail(word, "unknown parameter");
    }
}

}  // namespace

RendermanParameters read_parameters(std::string_view text) {
    RendermanParameters out;
    Times times;
    std::vector<std::string> seen;
    for (const Word& word : words_of(text)) {
        if (!word.name.empty() && std::ranges::find(seen, word.name) != seen.end()) {
            fail(word, "is set twice");
        }
        seen.push_back(word.name);
        take(word, out, times);
    }
    if (out.file.empty()) {
        throw std::invalid_argument(
            "no file: expected a groom's .toml, .hair or .h5 file");
    }
    if (times.samples.empty() && times.has_frame) times.samples = {0};
    if (times.motion.empty()) times.motion = times.samples;
    if (times.motion.size() != times.samples.size()) {
        throw std::invalid_argument("motion: expected as many times as samples");
    }
    for (const double sample : times.samples) out.times.push_back(times.frame + sample);
    out.motion.assign(times.motion.begin(), times.motion.end());
    return out;
}

}  // namespace lancret
