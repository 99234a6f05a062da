// The tree's own rules: which folder may include which, and where third parties stay.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace lancret {
namespace {

const std::filesystem::path kRoot = LANCRET_SOURCE_DIR;
constexpr const char* kLayers[] = {"guides", "sim", "procedural", "render_test", "tools"};
constexpr const char* kTestFolders[] = {"tests", "bench"};
constexpr std::size_t kMaxLines = 350;

/// One #include of a file of the tree.
struct Include {
    std::string file;  ///< that says it, from the root
    std::string name;  ///< what it names
    bool quoted;       ///< "..." rather than <...>
};

bool begins(const std::string& text, const std::string& start) {
    return text.compare(0, start.size(), start) == 0;
}

std::string folder_of(const std::string& path) { return path.substr(0, path.find('/')); }

/// The includes in `text`, the contents of `file`.
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

/// The folders that a folder's files may include.
std::vector<std::string> allowed(const std::string& folder) {
    if (folder == "guides") return {"guides"};
    if (folder == "sim") return {"guides", "sim"};
    if (folder == "procedural") return {"guides", "procedural"};
    if (folder == "render_test") return {"guides", "procedural", "render_test"};
    if (folder == "tools") return {"guides", "sim", "procedural", "render_test", "tools"};
    return {"guides", "sim", "procedural", "render_test", "tools", "tests", "bench"};
}

/// What is wrong with a quoted include: empty where nothing is.
std::string layering_fault(const Include& include) {
    if (!include.quoted) return {};
    if (include.name.find('/') == std::string::npos || include.name.find("..") == 0) {
        return include.file + ": \"" + include.name + "\" is not written from the root";
    }
    const auto may = allowed(folder_of(include.file));
    if (std::ranges::find(may, folder_of(include.name)) == may.end()) {
        return include.file + " may not include " + include.name;
    }
    return {};
}

/// A third party: how its headers begin, and how the files that may know it begin.
struct ThirdParty {
    std::vector<std::string> headers, files;
};
const ThirdParty kThirdParties[] = {
    {{"embree"},
     {"render_test/scene/embree_scene.", "guides/mesh/closest_point.",
      "bench/render_test/bare_embree."}},
    {{"OpenImageIO", "OpenEXR", "Imath", "Imf", "Iex"},
     {"render_test/image/", "procedural/bind/region_map.", "tests/render_test/image/",
      "tests/procedural/bind/region_map_test.", "tests/tools/good_runs_test.",
      "tests/tools/view_layers."}},
    {{"hdf5", "H5"},
     {"guides/files/guide_cache", "tests/guides/files/guide_cache_test."}},
    {{"tiny_obj_loader"}, {"guides/files/obj_file."}},
    {{"nanoflann"}, {"guides/base/point_tree.h"}},
    {{"hwy/"}, {"procedural/kernels/", "tests/procedural/kernels/every_target.h"}},
    {{"toml"}, {"guides/toml/table", "guides/toml/overrides."}},
    {{"CLI/"},
     {"tools/", "bench/render_test/picture_bench.", "bench/pipeline/pipeline_bench."}},
    {{"unsupported/"}, {"tests/"}},
    {{"gtest", "gmock"}, {"tests/"}},
    {{"benchmark/"}, {"bench/"}},
};

/// The figures of an evaluation share nothing with what they measure.
std::string judge_fault(const Include& include) {
    constexpr const char* kJudged[] = {"procedural/blend/",
                                       "procedural/bind/",
                                       "procedural/expand/",
                                       "procedural/kernels/",
                                       "procedural/evaluate/hold_out",
                                       "procedural/evaluate/evaluation",
                                       "procedural/check/"};
    const bool judge = begins(include.file, "procedural/evaluate/strand_figures.");
    return judge && std::ranges::any_of(
                        kJudged,
                        [&](const char* start) { return begins(include.name, start); })
               ? include.file + " may not include " + include.name
               : std::string();
}

std::string third_party_fault(const Include& include) {
    if (include.quoted) return {};
    const auto starts = [](const std::string& text) {
        return [&text](const std::string& start) { return begins(text, start); };
    };
    for (const ThirdParty& party : kThirdParties) {
        if (std::ranges::any_of(party.headers, starts(include.name)) &&
            std::ranges::none_of(party.files, starts(include.file))) {
            return include.file + " may not include <" + include.name + ">";
        }
    }
    return {};
}

/// What hosts load stands on the C interface alone.
std::string adapter_fault(const Include& include) {
    const std::string folder = "procedural/adapters/";
    return begins(include.file, folder) && include.quoted &&
                   !begins(include.name, folder) &&
                   include.name != "procedural/lancret_procedural.h"
               ? include.file + " may not include " + include.name
               : std::string();
}

/// The path tracer and the preview.
bool is_of_picture(const std::string& path) {
    constexpr const char* kPicture[] = {"render_test/", "tools/preview/"};
    return std::ranges::any_of(kPicture,
                               [&](const char* start) { return begins(path, start); });
}

/// A picture has its strands from the plugin and no other way in: settings, tolerances,
/// texts and the curves' own memory are all that the path tracer and the preview share
/// with what grows them.
std::string picture_fault(const Include& include) {
    constexpr const char* kShared[] = {
        "lancret_procedural", "curves/curves",    "curves/strand_values", "bind/report",
        "check/strand",       "check/tolerances", "check/json_numbers"};
    const std::string folder = "procedural/";
    const auto shared = [&](const char* name) {
        return include.name == folder + name + ".h";
    };
    return is_of_picture(include.file) && begins(include.name, folder) &&
                   std::ranges::none_of(kShared, shared)
               ? include.file + " may not include " + include.name
               : std::string();
}

std::string source_fault(const Include& include) {
    return std::filesystem::path(include.name).extension() == ".cpp"
               ? include.file + " includes a source file, " + include.name
               : std::string();
}

struct SourceFile {
    std::string path, text;  ///< from the root
};

const std::vector<SourceFile>& tree() {
    static const std::vector<SourceFile> files = [] {
        std::vector<SourceFile> out;
        const auto add = [&](const char* folder) {
            if (!std::filesystem::exists(kRoot / folder)) return;
            for (const auto& entry :
                 std::filesystem::recursive_directory_iterator(kRoot / folder)) {
                const std::string kind = entry.path().extension().string();
                if (kind != ".h" && kind != ".cpp") continue;
                std::ifstream stream(entry.path());
                out.push_back({entry.path().lexically_relative(kRoot).generic_string(),
                               {std::istreambuf_iterator<char>(stream), {}}});
            }
        };
        for (const char* folder : kLayers) add(folder);
        for (const char* folder : kTestFolders) add(folder);
        return out;
    }();
    return files;
}

void expect_faultless(const std::function<std::string(const Include&)>& fault) {
    for (const SourceFile& file : tree()) {
        for (const Include& include : includes_in(file.path, file.text)) {
            EXPECT_EQ(fault(include), "");
        }
    }
}

TEST(Layering, TheTreeIsRead) {
    // So that a moved folder does not leave the tests below with nothing to look at.
    std::size_t includes = 0;
    for (const SourceFile& file : tree()) {
        includes += includes_in(file.path, file.text).size();
    }
    EXPECT_GT(tree().size(), 100u);
    EXPECT_GT(includes, 300u);
    for (const char* folder : {"guides", "procedural", "render_test", "tools"}) {
        EXPECT_TRUE(std::ranges::any_of(tree(), [&](const SourceFile& f) {
            return folder_of(f.path) == folder;
        })) << folder;
    }
}

TEST(Layering, RulesFindWhatBreaksThem) {
    const auto one = [](const std::string& file, const std::string& line) {
        return includes_in(file, "// a\n" + line + "\nint x;\n").at(0);
    };
    EXPECT_NE(layering_fault(one("guides/a.h", "#include \"procedural/b.h\"")), "");
    EXPECT_NE(layering_fault(one("sim/a.h", "#include \"procedural/b.h\"")), "");
    EXPECT_NE(layering_fault(one("procedural/a.h", "#include \"sim/b.h\"")), "");
    EXPECT_NE(layering_fault(one("procedural/a.h", "# include \"render_test/b.h\"")), "");
    EXPECT_NE(layering_fault(one("render_test/a.cpp", "#include \"tools/b.h\"")), "");
    EXPECT_NE(layering_fault(one("tools/a.cpp", "#include \"tests/b.h\"")), "");
    EXPECT_NE(layering_fault(one("guides/a.cpp", "#include \"a.h\"")), "");
    EXPECT_NE(layering_fault(one("guides/a.cpp", "#include \"../guides/a.h\"")), "");
    EXPECT_EQ(layering_fault(one("tools/a.cpp", "#include \"render_test/b.h\"")), "");
    EXPECT_NE(
        third_party_fault(one("render_test/trace/render.cpp", "#include <embree3/x.h>")),
        "");
    EXPECT_NE(
        third_party_fault(one("guides/strand/curve.cpp", "#include <nanoflann.hpp>")),
        "");
    EXPECT_NE(third_party_fault(one("procedural/a.cpp", "#include <CLI/CLI.hpp>")), "");
    EXPECT_EQ(third_party_fault(one("guides/strand/curve.cpp", "#include <vector>")), "");
    EXPECT_NE(source_fault(one("tests/a.cpp", "#include \"guides/helix/helix.cpp\"")),
              "");
}

TEST(Layering, FoldersIncludeOnlyWhatTheyMay) { expect_faultless(layering_fault); }

TEST(Layering, ThirdPartiesStayInTheirFiles) { expect_faultless(third_party_fault); }

TEST(Layering, FiguresKnowNothingOfTheBlends) {
    const auto include = [](const char* name) {
        return Include{"procedural/evaluate/strand_figures.cpp", name, true};
    };
    EXPECT_NE(judge_fault(include("procedural/blend/blend.h")), "");
    EXPECT_NE(judge_fault(include("procedural/expand/expand.h")), "");
    EXPECT_EQ(judge_fault(include("procedural/evaluate/strand_figures.h")), "");
    expect_faultless(judge_fault);
}

TEST(Layering, AdaptersKnowTheCInterfaceAlone) {
    const auto include = [](const char* name) {
        return Include{"procedural/adapters/renderman.cpp", name, true};
    };
    EXPECT_NE(adapter_fault(include("procedural/expand/expand.h")), "");
    EXPECT_NE(adapter_fault(include("guides/helix/helix.h")), "");
    EXPECT_EQ(adapter_fault(include("procedural/lancret_procedural.h")), "");
    EXPECT_EQ(adapter_fault(include("procedural/adapters/ri.h")), "");
    expect_faultless(adapter_fault);
}

/// All that a file includes, and what that includes.
std::set<std::string> reach_of(const std::string& path) {
    std::set<std::string> out;
    std::vector<std::string> open{path};
    while (!open.empty()) {
        const std::string next = open.back();
        open.pop_back();
        const auto file = std::ranges::find(tree(), next, &SourceFile::path);
        if (file == tree().end()) continue;
        for (const Include& include : includes_in(file->path, file->text)) {
            if (include.quoted && out.insert(include.name).second)
                open.push_back(include.name);
        }
    }
    return out;
}

TEST(Layering, NothingInAPictureReachesWhatGrowsStrands) {
    const auto grows = [](const std::string& path) {
        const std::set<std::string> reach = reach_of(path);
        for (const char* name :
             {"groom/ready_groom", "chunk/chunked_groom", "groom/children",
              "motion/moving_groom", "chunk/box", "abi/prepared"}) {
            const std::string header = "procedural/" + std::string(name) + ".h";
            if (reach.contains(header)) return header;
        }
        return std::string();
    };
    EXPECT_NE(grows("tools/check.cpp"), "");
    for (const SourceFile& file : tree()) {
        if (is_of_picture(file.path)) {
            EXPECT_EQ(grows(file.path), "") << file.path;
        }
    }
}

TEST(Layering, PicturesHaveTheirStrandsFromThePlugin) {
    const auto include = [](const char* file, const char* name) {
        return Include{file, name, true};
    };
    EXPECT_NE(picture_fault(
                  include("render_test/trace/render.cpp", "procedural/expand/expand.h")),
              "");
    EXPECT_NE(picture_fault(
                  include("tools/preview/preview.cpp", "procedural/groom/ready_groom.h")),
              "");
    EXPECT_EQ(
        picture_fault(include("tools/preview/preview.cpp", "procedural/curves/curves.h")),
        "");
    EXPECT_EQ(picture_fault(include("tools/check.cpp", "procedural/check/check.h")), "");
    expect_faultless(picture_fault);
}

TEST(Layering, NothingIncludesASourceFile) { expect_faultless(source_fault); }

TEST(Layering, QuotedIncludesExist) {
    for (const SourceFile& file : tree()) {
        for (const Include& include : includes_in(file.path, file.text)) {
            if (include.quoted) {
                EXPECT_TRUE(std::filesystem::exists(kRoot / include.name))
                    << file.path << ": " << include.name;
            }
        }
    }
}

TEST(Layering, NoFileOfALayerIsLong) {
    for (const SourceFile& file : tree()) {
        if (std::ranges::find(kLayers, folder_of(file.path)) == std::end(kLayers))
            continue;
        // A host includes one header: its contract is not cut.
        if (file.path == "procedural/lancret_procedural.h") continue;
        EXPECT_LE(std::size_t(std::ranges::count(file.text, '\n')), kMaxLines)
            << file.path;
    }
}

TEST(Layering, HeadersGuardThemselves) {
    for (const SourceFile& file : tree()) {
        // The C interface is for compilers that know no pragma as well.
        if (!file.path.ends_with(".h") || file.path == "procedural/lancret_procedural.h")
            continue;
        EXPECT_TRUE(begins(file.text, "#pragma once\n")) << file.path;
    }
}

}  // namespace
}  // namespace lancret
