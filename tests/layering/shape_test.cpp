// How files, folders and functions look.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/layering/layers.h"
#include "tests/layering/source_tree.h"

namespace lancret::layering {
namespace {

bool is_product(const std::string& path) {
    return std::ranges::count(kTops, top_of(path)) > 0;
}

std::string header_of(const std::string& path) {
    return path.substr(0, path.rfind('.')) + ".h";
}

bool exists(const std::string& path) {
    return std::ranges::binary_search(source_tree(), path, {}, &SourceFile::path);
}

bool needs_no_header(const std::string& path) {
    return std::ranges::any_of(
        kWithoutHeader, [&](std::string_view start) { return path.starts_with(start); });
}

TEST(Shape, ASourceHasAHeaderAndIncludesItFirst) {
    for (const SourceFile& file : source_tree()) {
        if (!is_product(file.path) || !file.path.ends_with(".cpp")) continue;
        const std::string header = header_of(file.path);
        if (!exists(header)) {
            EXPECT_TRUE(needs_no_header(file.path)) << file.path << " has no " << header;
            continue;
        }
        // A kernel's source is read once per instruction set, its header with the first.
        if (file.path.starts_with("procedural/kernels/")) continue;
        const std::vector<Include> includes = includes_in(file.path, file.text);
        ASSERT_FALSE(includes.empty()) << file.path;
        EXPECT_EQ(includes.front().name, header)
            << file.path << " includes another header first";
    }
}

TEST(Shape, FoldersAreSmall) {
    std::map<std::string, std::size_t> files;
    for (const SourceFile& file : source_tree()) ++files[folder_of(file.path)];
    for (const auto& [folder, count] : files) {
        EXPECT_LE(count, folder == "procedural/abi" ? kMaxInterfaceFiles : kMaxFiles)
            << folder;
    }
}

TEST(Shape, TopFoldersHoldFoldersOnly) {
    const std::set<std::string> tops = {"guides", "procedural", "render_test"};
    for (const SourceFile& file : source_tree()) {
        if (file.path == kInterface) continue;
        EXPECT_FALSE(tops.contains(folder_of(file.path)))
            << file.path << " belongs into a folder";
    }
}

TEST(Shape, FilesAreShort) {
    for (const SourceFile& file : source_tree()) {
        // A host includes one header: its contract is not cut.
        if (!is_product(file.path) || file.path == kInterface) continue;
        EXPECT_LE(std::size_t(std::ranges::count(file.text, '\n')), kMaxFileLines)
            << file.path;
    }
}

TEST(Shape, FunctionsAreShort) {
    for (const SourceFile& file : source_tree()) {
        if (!is_product(file.path)) continue;
        for (const Function& function : functions_in(file.path, file.text)) {
            EXPECT_LE(function.lines, kMaxFunctionLines)
                << file.path << ':' << function.line << ": " << function.name;
        }
    }
}

TEST(Shape, FunctionsAreFound) {
    const std::string text =
        "int a(int x) {\n    return x;\n}\n\nvoid b(int x,\n       int y) {\n    if (x) "
        "{\n    }\n}\n\n"
        "void declared(int);\nint one() { return 1; }\nstruct S {\n    int x;\n};\n";
    const std::vector<Function> found = functions_in("f.cpp", text);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].line, 1u);
    EXPECT_EQ(found[0].lines, 3u);
    EXPECT_EQ(found[1].line, 5u);
    EXPECT_EQ(found[1].lines, 5u);
    std::size_t all = 0;
    for (const SourceFile& file : source_tree()) {
        all += functions_in(file.path, file.text).size();
    }
    EXPECT_GT(all, 1000u);
}

TEST(Shape, BodiesOnLinesOfTheirOwnHaveBraces) {
    EXPECT_EQ(bare_bodies_in("if (x)\n    y();\n").size(), 1u);
    EXPECT_EQ(bare_bodies_in("for (int i = 0;\n     i < f(1); ++i)\n    y();\n").size(),
              1u);
    EXPECT_EQ(bare_bodies_in("if (x) {\n    y();\n} else\n    z();\n").size(), 1u);
    EXPECT_TRUE(
        bare_bodies_in("if (x) y();\nif (f(\")\")) {\n}\nwhile (a &&\n       b) {\n}\n")
            .empty());
    for (const SourceFile& file : source_tree()) {
        for (const std::size_t line : bare_bodies_in(file.text)) {
            ADD_FAILURE() << file.path << ':' << line
                          << ": the body of a condition or loop needs braces";
        }
    }
}

TEST(Shape, HeadersGuardThemselves) {
    for (const SourceFile& file : source_tree()) {
        // The C interface is also for compilers without the pragma.
        if (!file.path.ends_with(".h") || file.path == kInterface) continue;
        EXPECT_TRUE(file.text.starts_with("#pragma once\n")) << file.path;
    }
}

}  // namespace
}  // namespace lancret::layering
