// Texts that are nearly grooms never crash; they give a status, and if they are invalid
// an error with a place in the text.

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "guides/base/hash.h"
#include "tests/abi/plugin.h"

namespace lancret {
namespace {

const std::string kTexts[] = {
    "[scene]\nup = \"Z\"\nmetres_per_unit = 0.01\ngravity = [0, 0, -981]\n"
    "[guides]\ncount = 8\nsegments = 4\nmade.strands = 12\nmade.points = 8\n"
    "[strands]\ncount = 20\nseed = 7\ndensity = 0.5\nblend = \"detail\"\n"
    "neighbours = 3\nexponent = 2.5\ntolerance = 0.1\n"
    "[width]\nroot = 0.01\ntip = 0.005\n",
    "[guides]\nshare = 0.5\nmade = {strands = 10, points = 6, kind = \"lawn\"}\n"
    "[strands]\ncount = 10\nintervals = 4\nfacing = false\nmax_distance = 9.0\n"
    "max_angle_degrees = 60\ncurve = \"hermite\"\nshape = \"round\"\n"
    "[[partings]]\npoints = [[0, 10, 0], [0, 11, 3]]\n"
    "[motion]\npivot = [0, 1, 0]\n[[motion.keys]]\nframe = 1\nmove = [0, 0, 1]\n"};

const char* const kWords[] = {"[",   "]",    "[[",      "]]",   "=",     "\"",  "\n",
                              "nan", "-1",   "1e308",   "0",    "true",  "{",   "}",
                              ",",   "inf",  "0x7f",    "\\u0", "'",     "#",   "guides",
                              ".",   "\xff", "[width]", "3.5",  "count", "\t ", "\"\"\""};

/// `text` with a few bytes removed, duplicated, changed or moved.
std::string mutated(std::string text, std::uint64_t seed) {
    std::uint64_t state = seed;
    const auto draw = [&](std::uint64_t below) {
        state = mix_bits(state + 0x9e3779b97f4a7c15u);
        return std::size_t(state % below);
    };
    // Half of the mutations change digits only, which mostly gives valid grooms.
    const bool digits_only = draw(2) == 0;
    for (std::size_t n = 1 + draw(4); n > 0 && !text.empty(); --n) {
        const std::size_t at = draw(text.size());
        const std::size_t length = 1 + draw(12);
        if (digits_only) {
            const std::size_t digit = text.find_first_of("0123456789", at);
            if (digit != std::string::npos) text[digit] = char('0' + draw(10));
            continue;
        }
        switch (draw(5)) {
            case 0:
                text.erase(at, length);
                break;
            case 1:
                text.insert(at, text.substr(draw(text.size()), length));
                break;
            case 2:
                text[at] = char(draw(256));
                break;
            case 3:
                text.insert(at, kWords[draw(std::size(kWords))]);
                break;
            default:
                text[at] = char('0' + draw(10));
                break;
        }
    }
    return text;
}

/// Whether a mutated text has no large numbers. A large count ("20" with one more digit)
/// is valid but slow.
bool is_small(const std::string& text) {
    static const std::regex kNumber("[0-9_]{4,}|[eExX]");
    static const std::regex kName("[a-zA-Z_]{2,}");
    return !std::regex_search(std::regex_replace(text, kName, ""), kNumber);
}

void fuzz(std::uint64_t first, int texts) {
    const lancret_host host = make_host(1);
    const auto context = make_context(&host);
    static const std::regex kPlace("^groom(:[0-9]+)?: .+");
    int good = 0, bad = 0, with_line = 0;
    for (int i = 0; i < texts; ++i) {
        const std::string text = mutated(kTexts[i % 2], first + std::uint64_t(i));
        // C strings end at a null.
        if (text.find('\0') != std::string::npos || !is_small(text)) continue;
        const Opened out = open(context.get(), text_source(text));
        if (out.status == LANCRET_OK) {
            ++good;
            const lancret_groom_info info = info_of(out.groom.get());
            if (info.strands > 1000) continue;
            const auto options = make_options(int(i % 5));
            const lancret_status status =
                expand_with(out.groom.get(), 0, options, [](const lancret_curves& c) {
                    for (std::size_t p = 0; p < 4 * std::size_t(c.points); ++p) {
                        EXPECT_TRUE(std::isfinite(c.positions[0][p]));
                    }
                    return LANCRET_OK;
                });
            EXPECT_EQ(status, LANCRET_OK) << text;
        } else {
            ++bad;
            EXPECT_EQ(out.status, LANCRET_BAD_INPUT) << out.error << '\n' << text;
            EXPECT_EQ(out.error.find('\n'), std::string::npos) << out.error;
            // All errors are those of the text, mostly with a line number.
            EXPECT_TRUE(std::regex_match(out.error, kPlace)) << out.error;
            with_line += out.error.find("groom:") == 0;
        }
    }
    for (const std::string& text : kTexts) {
        const Opened out = open(context.get(), text_source(text));
        EXPECT_EQ(out.status, LANCRET_OK) << out.error;
    }
    // Mutations are both valid and invalid.
    EXPECT_GT(good, texts / 20);
    EXPECT_GT(bad, texts / 10);
    EXPECT_GT(with_line, bad / 2);
}

TEST(PluginFuzz, TextsThatAreNearlyGroomsNeverCrash) { fuzz(1, 300); }

TEST(SlowPluginFuzz, ManyTextsThatAreNearlyGroomsNeverCrash) { fuzz(1 << 20, 8000); }

}  // namespace
}  // namespace lancret
