#include "tests/adapters/rib_reader.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <stdexcept>

namespace lancret {
namespace {

/// An argument of a request.
struct Argument {
    std::string text;
    std::vector<float> numbers;
    bool is_text = false;
};

struct Request {
    std::string name;
    std::vector<Argument> arguments;
};

[[noreturn]] void fail(const std::string& what) { throw std::runtime_error(what); }

class Reader {
  public:
    explicit Reader(const std::string& text) : at_(text.c_str()) {}

    bool next(Request& out) {
        space();
        if (*at_ == '\0') return false;
        out = {};
        while (std::isalpha(static_cast<unsigned char>(*at_))) out.name += *at_++;
        if (out.name.empty()) fail(std::string("expected a request at ") + at_);
        for (space(); *at_ && !std::isalpha(static_cast<unsigned char>(*at_)); space()) {
            out.arguments.push_back(argument());
        }
        return true;
    }

  private:
    const char* at_;

    void space() {
        while (*at_ == '#' || std::isspace(static_cast<unsigned char>(*at_))) {
            if (*at_ == '#') {
                while (*at_ && *at_ != '\n') ++at_;
            } else {
                ++at_;
            }
        }
    }

    float number() {
        char* end = nullptr;
        const float out = std::strtof(at_, &end);
        if (end == at_) fail(std::string("expected a number at ") + at_);
        at_ = end;
        return out;
    }

    Argument argument() {
        Argument out;
        if (*at_ == '"') {
            out.is_text = true;
            for (++at_; *at_ != '"'; ++at_) {
                if (!*at_) fail("unterminated string");
                out.text += *at_;
            }
            ++at_;
        } else if (*at_ == '[') {
            ++at_;
            for (space(); *at_ != ']'; space()) out.numbers.push_back(number());
            ++at_;
        } else {
            out.numbers = {number()};
        }
        return out;
    }
};

RibCurves curves_of(const Request& request) {
    const auto& a = request.arguments;
    if (a.size() < 3 || a.size() % 2 == 0) fail("Curves: wrong number of arguments");
    RibCurves out;
    out.type = a[0].text;
    out.counts.assign(a[1].numbers.begin(), a[1].numbers.end());
    out.wrap = a[2].text;
    for (std::size_t i = 3; i < a.size(); i += 2) {
        if (!a[i].is_text || a[i + 1].is_text) fail("Curves: expected names and values");
        out.values[a[i].text] = a[i + 1].numbers;
    }
    return out;
}

void take(const Request& request, RibChunk& chunk, bool& in_motion) {
    const std::string& name = request.name;
    if (name == "Bound") {
        std::copy_n(request.arguments.at(0).numbers.begin(), 6, chunk.bound.begin());
    } else if (name == "Basis") {
        chunk.basis = request.arguments.at(2).numbers;
        chunk.step = int(request.arguments.at(3).numbers.at(0));
    } else if (name == "MotionBegin") {
        if (in_motion || !chunk.curves.empty()) fail("MotionBegin out of place");
        in_motion = true;
        chunk.motion = request.arguments.at(0).numbers;
    } else if (name == "MotionEnd") {
        if (!in_motion) fail("MotionEnd without MotionBegin");
        in_motion = false;
        if (chunk.curves.size() != chunk.motion.size()) fail("times without curves");
    } else if (name == "Curves") {
        if (!in_motion && !chunk.curves.empty()) fail("Curves twice");
        chunk.curves.push_back(curves_of(request));
    } else {
        fail("unknown request " + name);
    }
}

}  // namespace

std::vector<RibChunk> read_rib(const std::string& text) {
    std::vector<RibChunk> out;
    Reader reader(text);
    Request request;
    int depth = 0;
    bool in_motion = false;
    while (reader.next(request)) {
        if (request.name == "version") continue;
        if (request.name == "AttributeBegin") {
            if (in_motion) fail("AttributeBegin in a motion block");
            if (++depth == 1) out.emplace_back();
        } else if (request.name == "AttributeEnd") {
            if (in_motion) fail("AttributeEnd in a motion block");
            if (--depth < 0) fail("AttributeEnd without AttributeBegin");
        } else if (depth == 0) {
            fail(request.name + " outside of attributes");
        } else {
            take(request, out.back(), in_motion);
        }
    }
    if (depth != 0 || in_motion) fail("unterminated block");
    return out;
}

std::vector<std::array<float, 4>> places_on(const RibChunk& chunk,
                                            const RibCurves& curves, int steps) {
    const std::vector<float>& points = curves.values.at("P");
    const auto constant = curves.values.find("constantwidth");
    const auto value = [&](std::size_t vertex, int axis) {
        if (axis < 3) return points[3 * vertex + std::size_t(axis)];
        if (constant != curves.values.end()) return constant->second[0] / 2;
        return curves.values.at("vertex float width")[vertex] / 2;
    };
    std::vector<std::array<float, 4>> out;
    std::size_t first = 0;
    const bool cubic = !chunk.basis.empty();
    for (const int count : curves.counts) {
        const int window = cubic ? 4 : 2;
        for (int j = 0; j + window <= count; j += chunk.step) {
            for (int i = 0; i <= steps; ++i) {
                const float t = float(i) / float(steps);
                const float powers[4] = {t * t * t, t * t, t, 1};
                std::array<float, 4> place{};
                for (int k = 0; k < window; ++k) {
                    float weight = k == 0 ? 1 - t : t;
                    if (cubic) {
                        weight = 0;
                        for (int p = 0; p < 4; ++p) {
                            weight += powers[p] * chunk.basis[std::size_t(4 * p + k)];
                        }
                    }
                    for (int a = 0; a < 4; ++a) {
                        place[std::size_t(a)] +=
                            weight * value(first + std::size_t(j + k), a);
                    }
                }
                out.push_back(place);
            }
        }
        first += std::size_t(count);
    }
    return out;
}

}  // namespace lancret
