// Which file may include which, by the tables of layers.h.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "tests/layering/layers.h"
#include "tests/layering/source_tree.h"

namespace lancret::layering {
namespace {

const Layer* layer_of(std::string_view folder) {
    const auto row = std::ranges::find(kLayers, folder, &Layer::folder);
    return row == std::end(kLayers) ? nullptr : row;
}

/// The words of `list`, which are separated by spaces.
std::vector<std::string> words_of(std::string_view list) {
    std::istringstream stream{std::string(list)};
    return {std::istream_iterator<std::string>(stream), {}};
}

bool has_word(std::string_view list, std::string_view word) {
    return std::ranges::count(words_of(list), word) > 0;
}

bool starts_any(std::string_view path, std::span<const std::string_view> starts) {
    return std::ranges::any_of(
        starts, [&](std::string_view start) { return path.starts_with(start); });
}

/// The rules: each returns what is wrong with a quoted include, empty if nothing is.
std::string layer_fault(const Include& include) {
    const std::string message = include.file + " may not include " + include.name;
    if (include.name.find('/') == std::string::npos || include.name.starts_with("..")) {
        return include.file + ": \"" + include.name + "\" is not written from the root";
    }
    if (include.name.ends_with(".cpp")) return message;
    if (include.name == kInterface) {
        return starts_any(include.file, kHosts) ? "" : message;
    }
    const std::string from = folder_of(include.file), to = folder_of(include.name);
    const std::string top = top_of(include.file);
    if (from == to || std::ranges::count(kTestTops, top) > 0) return {};
    if (top == "tools") {
        return std::ranges::count(kTops, top_of(include.name)) > 0 ? "" : message;
    }
    const Layer* layer = layer_of(from);
    if (!layer) {
        return include.file + ": its folder is not listed in tests/layering/layers.h";
    }
    return has_word(layer->may_include, to) ? "" : message;
}

std::string private_fault(const Include& include) {
    for (const Private& rule : kPrivates) {
        if (include.name.starts_with(rule.headers) &&
            !begins_with_any(include.file, rule.users)) {
            return include.file + " may not include " + include.name;
        }
    }
    return {};
}

std::string narrow_fault(const Include& include) {
    for (const Narrow& rule : kNarrow) {
        if (include.file.starts_with(rule.files) &&
            include.name.starts_with(rule.layer) &&
            !begins_with_any(include.name, rule.headers)) {
            return include.file + " may not include " + include.name;
        }
    }
    return {};
}

std::string third_party_fault(const Include& include) {
    for (const ThirdParty& party : kThirdParties) {
        if (begins_with_any(include.name, party.headers) &&
            !begins_with_any(include.file, party.files)) {
            return include.file + " may not include <" + include.name + ">";
        }
    }
    return {};
}

void expect_faultless(bool quoted,
                      const std::function<std::string(const Include&)>& fault) {
    for (const SourceFile& file : source_tree()) {
        for (const Include& include : includes_in(file.path, file.text)) {
            if (include.quoted == quoted) {
                EXPECT_EQ(fault(include), "");
            }
        }
    }
}

/// All that a file includes, and what that includes.
std::set<std::string> reach_of(const std::string& path) {
    std::set<std::string> out;
    std::vector<std::string> open{path};
    while (!open.empty()) {
        const std::string next = open.back();
        open.pop_back();
        const auto file = std::ranges::find(source_tree(), next, &SourceFile::path);
        if (file == source_tree().end()) continue;
        for (const Include& include : includes_in(file->path, file->text)) {
            if (include.quoted && out.insert(include.name).second) {
                open.push_back(include.name);
            }
        }
    }
    return out;
}

/// The first header that grows strands and that `path` reaches; empty if there is none.
std::string grower_reached(const std::string& path) {
    for (const std::string& header : reach_of(path)) {
        if (starts_any(header, kGrowers)) return header;
    }
    return {};
}

TEST(Layering, TheTreeIsRead) {
    // So that a moved folder does not leave the tests below with nothing to look at.
    std::size_t includes = 0;
    for (const SourceFile& file : source_tree()) {
        includes += includes_in(file.path, file.text).size();
    }
    EXPECT_GT(source_tree().size(), 500u);
    EXPECT_GT(includes, 2000u);
    for (const Layer& layer : kLayers) {
        EXPECT_TRUE(std::ranges::any_of(
            source_tree(),
            [&](const SourceFile& file) { return folder_of(file.path) == layer.folder; }))
            << layer.folder << " has no file";
    }
}

TEST(Layering, LayersIncludeOnlyLayersAboveThem) {
    // So the table has no circle.
    for (const Layer& layer : kLayers) {
        for (const Layer& other : kLayers) {
            if (&other < &layer) continue;
            EXPECT_FALSE(has_word(layer.may_include, other.folder))
                << layer.folder << " -> " << other.folder;
        }
    }
}

TEST(Layering, EveryWordOfTheTableIsALayer) {
    for (const Layer& layer : kLayers) {
        for (const std::string& word : words_of(layer.may_include)) {
            EXPECT_NE(layer_of(word), nullptr) << layer.folder << ": " << word;
        }
    }
}

TEST(Layering, RulesFindWhatBreaksThem) {
    const auto one = [](const std::string& file, const std::string& line) {
        return includes_in(file, "// a\n" + line + "\nint x;\n").at(0);
    };
    for (const auto& [file, line] : {
             std::pair{"guides/base/a.h", "#include \"procedural/bind/b.h\""},
             std::pair{"guides/base/a.h", "#include \"guides/mesh/b.h\""},
             std::pair{"sim/rod/a.h", "#include \"procedural/bind/b.h\""},
             std::pair{"sim/segment/a.h", "#include \"sim/rod/b.h\""},
             std::pair{"procedural/bind/a.h", "#include \"sim/rod/b.h\""},
             std::pair{"procedural/bind/a.h", "# include \"procedural/expand/b.h\""},
             std::pair{"procedural/adapters/a.cpp", "#include \"guides/helix/helix.h\""},
             std::pair{"procedural/expand/a.cpp",
                       "#include \"procedural/lancret_procedural.h\""},
             std::pair{"render_test/trace/a.cpp", "#include \"tools/b.h\""},
             std::pair{"tools/a.cpp", "#include \"tests/b.h\""},
             std::pair{"guides/helix/a.cpp", "#include \"a.h\""},
             std::pair{"guides/helix/a.cpp", "#include \"../helix/a.h\""},
             std::pair{"guides/new/a.cpp", "#include \"guides/base/types.h\""},
             std::pair{"guides/a.cpp", "#include \"guides/base/types.h\""},
             std::pair{"tests/a.cpp", "#include \"guides/helix/helix.cpp\""},
         }) {
        EXPECT_NE(layer_fault(one(file, line)), "") << file << ' ' << line;
    }
    EXPECT_EQ(layer_fault(one("tools/a.cpp", "#include \"render_test/trace/b.h\"")), "");
    EXPECT_EQ(layer_fault(one("procedural/adapters/a.cpp",
                              "#include \"procedural/lancret_procedural.h\"")),
              "");
    EXPECT_NE(private_fault(
                  one("procedural/blend/a.cpp", "#include \"guides/frenet/cyclone.h\"")),
              "");
    EXPECT_NE(private_fault(
                  one("procedural/check/a.cpp", "#include \"procedural/kernels/b.h\"")),
              "");
    EXPECT_NE(narrow_fault(one("procedural/evaluate/strand_figures.cpp",
                               "#include \"procedural/blend/blend.h\"")),
              "");
    EXPECT_NE(narrow_fault(one("tools/preview/preview.cpp",
                               "#include \"procedural/groom/ready_groom.h\"")),
              "");
    EXPECT_EQ(narrow_fault(one("tools/preview/preview.cpp",
                               "#include \"procedural/curves/curves.h\"")),
              "");
    EXPECT_EQ(
        narrow_fault(one("tools/check.cpp", "#include \"procedural/check/check.h\"")),
        "");
    EXPECT_NE(
        third_party_fault(one("render_test/trace/render.cpp", "#include <embree3/x.h>")),
        "");
    EXPECT_NE(
        third_party_fault(one("guides/strand/curve.cpp", "#include <nanoflann.hpp>")),
        "");
    EXPECT_NE(third_party_fault(
                  one("guides/strand/curve.cpp", "#include <tbb/parallel_for.h>")),
              "");
    EXPECT_NE(third_party_fault(one("procedural/bind/a.cpp", "#include <CLI/CLI.hpp>")),
              "");
    EXPECT_EQ(third_party_fault(one("guides/strand/curve.cpp", "#include <vector>")), "");
}

TEST(Layering, FoldersIncludeOnlyWhatTheyMay) { expect_faultless(true, layer_fault); }

TEST(Layering, PrivateHeadersStayPrivate) { expect_faultless(true, private_fault); }

TEST(Layering, NarrowFilesIncludeOnlyTheirHeaders) {
    expect_faultless(true, narrow_fault);
}

TEST(Layering, ThirdPartiesStayInTheirFiles) {
    expect_faultless(false, third_party_fault);
}

TEST(Layering, NothingInAPictureReachesWhatGrowsStrands) {
    EXPECT_NE(grower_reached("tools/check.cpp"), "");
    for (const SourceFile& file : source_tree()) {
        if (starts_any(file.path, kPictures)) {
            EXPECT_EQ(grower_reached(file.path), "") << file.path;
        }
    }
}

TEST(Layering, QuotedIncludesExist) {
    const std::filesystem::path root = LANCRET_SOURCE_DIR;
    for (const SourceFile& file : source_tree()) {
        for (const Include& include : includes_in(file.path, file.text)) {
            if (include.quoted) {
                EXPECT_TRUE(std::filesystem::exists(root / include.name))
                    << file.path << ": " << include.name;
            }
        }
    }
}

}  // namespace
}  // namespace lancret::layering
