// The contract of RenderMan's procedurals: subdivided never, once or twice, from any
// thread, and freed.

#include <gtest/gtest.h>
#include <malloc.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <set>
#include <sstream>
#include <thread>

#include "tests/adapters/moving_groom.h"
#include "tests/adapters/rib_host.h"
#include "tests/adapters/rib_reader.h"

namespace lancret {
namespace {

const std::string kDso = LANCRET_RENDERMAN;

std::string parameters_of(const MadeGroom& groom, const std::string& rest = {}) {
    std::string out = "file='";
    return out.append(groom.path).append("' chunk_strands=32 ").append(rest);
}

TEST(RendermanContract, ExpandedTwiceIsTheSame) {
    const MadeGroom made;
    RibHost host(kDso);
    const RtPointer root = host.convert(parameters_of(made, "frame=1 samples=0,0.5"));
    host.subdivide_root(root);
    const std::size_t chunks = host.children.size();
    ASSERT_GT(chunks, 4u);
    std::vector<std::string> once;
    for (const Procedural& child : host.children) once.push_back(host.subdivide(child));
    for (std::size_t i = chunks; i-- > 0;) {
        EXPECT_EQ(host.subdivide(host.children[i]), once[i]);
    }
    host.subdivide_root(root);  // the root twice as well
    ASSERT_EQ(host.children.size(), 2 * chunks);
    for (std::size_t i = 0; i < chunks; ++i) {
        EXPECT_EQ(host.subdivide(host.children[chunks + i]), once[i]);
    }
    EXPECT_EQ(host.errors, "");
}

TEST(RendermanContract, ChunksOutliveTheirGroomsProcedural) {
    const MadeGroom made;
    RibHost host(kDso);
    const RtPointer root = host.convert(parameters_of(made));
    host.subdivide_root(root);
    const std::string before = host.subdivide(host.children.at(1));
    host.free_root(root);
    EXPECT_EQ(host.subdivide(host.children.at(1)), before);
}

TEST(RendermanContract, ManyThreadsSubdivideAtOnce) {
    const MadeGroom made;
    RibHost alone(kDso);
    const std::string expected = alone.rib_of(parameters_of(made));

    RibHost host(kDso);
    const RtPointer root = host.convert(parameters_of(made));
    {
        // Several threads subdivide the root: it is opened once and emits its children to
        // each.
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&] { host.subdivide_root(root); });
        }
    }
    std::vector<std::string> ribs(host.children.size());
    std::atomic<std::size_t> next{0};
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 8; ++t) {
            threads.emplace_back([&] {
                for (std::size_t i; (i = next++) < ribs.size();) {
                    ribs[i] = host.subdivide(host.children[i]);
                }
            });
        }
    }
    EXPECT_EQ(host.errors, "");
    const std::multiset<std::string> all(ribs.begin(), ribs.end());
    const std::set<std::string> distinct(ribs.begin(), ribs.end());
    std::size_t length = 0;
    for (const std::string& rib : distinct) {
        EXPECT_NE(expected.find(rib), std::string::npos);
        EXPECT_EQ(all.count(rib), 4u);
        length += rib.size();
    }
    EXPECT_EQ(length + std::string("##RenderMan RIB\nversion 3.04\n").size(),
              expected.size());
}

TEST(RendermanContract, ChunksThatAreNeverReachedLeakNothing) {
    const MadeGroom made;
    const std::size_t groom_bytes = AbiGroom(made.path, 32).info.bytes;
    ASSERT_GT(groom_bytes, 10000u);
    const auto cycle = [&] {
        RibHost host(kDso);
        host.free_root(host.convert(parameters_of(made)));  // never subdivided
        const RtPointer root = host.convert(parameters_of(made));
        host.subdivide_root(root);
        host.subdivide(host.children.at(0));  // one chunk of many
        host.free_root(root);
        host.free_children();
    };
    for (int i = 0; i < 4; ++i) cycle();  // one-time allocations of libraries
    const std::size_t before = mallinfo2().uordblks;
    for (int i = 0; i < 16; ++i) cycle();
    // A leak would add 16 grooms; caches of the allocator vary by less than one.
    EXPECT_LT(mallinfo2().uordblks, before + groom_bytes);
}

TEST(RendermanContract, AFailureIsReportedAndEmitsNothing) {
    const MadeGroom made;
    RibHost host(kDso);
    const RtPointer root = host.convert("file=none.toml");
    ASSERT_NE(root, nullptr);  // not opened before it is reached
    host.subdivide_root(root);
    EXPECT_TRUE(host.children.empty());
    EXPECT_NE(host.errors.find("none.toml"), std::string::npos) << host.errors;

    host.errors.clear();
    host.subdivide_root(host.convert(parameters_of(made, "strands.blend='oil'")));
    EXPECT_TRUE(host.children.empty());
    EXPECT_NE(host.errors.find("blend"), std::string::npos) << host.errors;
}

TEST(RendermanContract, AnInvalidStringIsRefusedWithItsPosition) {
    RibHost host(kDso);
    constexpr std::array<const char*, 2> kInvalid[] = {
        {"", "no file"},
        {"a.toml b.toml", "character 8"},
        {"a.toml speed=3", "speed: unknown parameter"},
        {"a.toml basis=cubic", "expected one of linear, b-spline"},
        {"a.toml frame=x", "expected a number in"},
        {"a.toml frame=nan", "expected a number in"},
        {"a.toml samples=1,0", "expected increasing times"},
        {"a.toml samples=0,1 motion=0", "expected as many times as samples"},
        {"a.toml density=0", "[1e-06, 1]"},
        {"a.toml primvars=id,colour", "not 'colour'"},
        {"a.toml chunk_strands=1.5", "expected a whole number"},
        {"a.toml chunk_strands=1000001", "[1, 1e+06]"},
        {"a.toml unit=1 unit=2", "set twice"},
        {"'a.toml", "unterminated quotation"},
        {"'a.toml'x", "expected a space"},
        {"=3", "expected a name"},
    };
    for (const auto& [text, reason] : kInvalid) {
        host.errors.clear();
        EXPECT_EQ(host.convert(text), nullptr) << text;
        EXPECT_NE(host.errors.find(reason), std::string::npos)
            << text << ": " << host.errors;
    }
    host.subdivide_function(nullptr, 1);  // as a renderer might all the same
    host.free_function(nullptr);
}

TEST(RendermanContract, AnyStringIsReadOrRefusedWithAReason) {
    RibHost host(kDso);
    const std::string words =
        "a.toml 'b c.hair' frame=12 samples=0,0.5 motion=0,1 basis=hermite "
        "max_error=1e-3 "
        "density=.5 strands_per_pixel=2 primvars=id,st,N chunk_strands=64 unit=2.54 "
        "threads=3 bound=tight strands.count=5 width.root=\"x\"";
    std::uint32_t state = 1;
    const auto draw = [&](std::size_t n) {
        state = state * 1664525u + 1013904223u;
        return std::size_t(state >> 8) % n;
    };
    int refused = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = words.substr(draw(words.size()), draw(80));
        for (std::size_t k = draw(4); k > 0 && !text.empty(); --k) {
            const std::size_t at = draw(text.size());
            switch (draw(3)) {
                case 0:
                    text[at] = char(1 + draw(255));
                    break;
                case 1:
                    text.erase(at, 1 + draw(5));
                    break;
                default:
                    text.insert(at, words.substr(draw(words.size()), draw(9)));
            }
        }
        host.errors.clear();
        const RtPointer root = host.convert(text);
        EXPECT_EQ(root == nullptr, !host.errors.empty()) << text;
        refused += root == nullptr;
        if (root) host.free_root(root);
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 19900);
}

/// Names that a shared library exports, as listed by nm.
std::set<std::string> exported(const std::string& library) {
    std::set<std::string> out;
    FILE* pipe = popen(("nm -D --defined-only '" + library + "'").c_str(), "r");
    char line[1024], name[1024];
    while (pipe && fgets(line, sizeof line, pipe)) {
        if (std::sscanf(line, "%*s %*s %1023s", name) == 1) out.insert(name);
    }
    if (pipe) pclose(pipe);
    return out;
}

TEST(RendermanContract, TheLibraryExportsOnlyItsThreeFunctions) {
    EXPECT_EQ(exported(kDso),
              (std::set<std::string>{"ConvertParameters", "Subdivide", "Free"}));
}

TEST(RendermanContract, ConcurrentFailuresNameTheirOwnGrooms) {
    const MovingGroom one, two;
    RibHost host(kDso);
    // More times than Lancret caches the guides of: those of the first time are read
    // again, from a cache file that was removed.
    constexpr int kTimes = 20, kTurns = 2000;
    for (const MovingGroom* groom : {&one, &two}) {
        for (int i = 0; i < kTimes; ++i) {
            host.subdivide_root(host.convert("file='" + groom->cache + "' frame=1." +
                                             std::to_string(10 + i)));
        }
        std::filesystem::remove(groom->cache);
    }
    ASSERT_EQ(host.children.size(), 2u * kTimes);
    const std::array firsts = {host.children[0], host.children[kTimes]};
    {
        std::vector<std::jthread> threads;
        for (const Procedural& child : firsts) {
            threads.emplace_back([&] {
                for (int i = 0; i < kTurns; ++i) host.subdivide(child);
            });
        }
    }
    std::istringstream lines(host.errors);
    int of_one = 0, of_two = 0;
    for (std::string line; std::getline(lines, line);) {
        const auto names = [&](const MovingGroom& groom) {
            return line.find(groom.cache + ", chunk 0: bad input, " + groom.cache +
                             ": has changed") != std::string::npos;
        };
        of_one += names(one);
        of_two += names(two);
    }
    EXPECT_EQ(of_one, kTurns);
    EXPECT_EQ(of_two, kTurns);
}

}  // namespace
}  // namespace lancret
