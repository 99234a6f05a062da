#include "guides/toml/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guides/base/errors.h"

namespace lancret {
namespace {

std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

constexpr std::string_view kText = "count = 5\n[width]\nroot = 0.1\nwidht = 2\n";

TEST(TomlTable, ReadsValuesOfEveryType) {
    const TomlTable table =
        TomlTable::from_text("a = 2\nb = [1, 2.5, 3]\nc = \"x\"\n", "t");
    EXPECT_EQ(table.number("a"), 2);
    EXPECT_EQ(table.vector("b"), Vec3(1, 2.5, 3));
    EXPECT_EQ(table.text("c"), "x");
    EXPECT_EQ(table.number("d"), std::nullopt);
    table.finish();
}

TEST(TomlTable, NamesFileLineAndNearestKeyOfATypo) {
    const TomlTable table = TomlTable::from_text(kText, "groom.toml");
    table.integer("count", 0, 10);
    const TomlTable width = table.table("width");
    width.number("root");
    width.number("width");
    EXPECT_EQ(error_of([&] { table.finish(); }),
              "groom.toml:4: unknown key 'widht' in [width], did you mean 'width'?");
}

TEST(TomlTable, NamesAnUnknownTable) {
    const TomlTable table = TomlTable::from_text("[strand]\ncount = 1\n", "g");
    table.table("strands");
    EXPECT_EQ(error_of([&] { table.finish(); }),
              "g:1: unknown key 'strand', did you mean 'strands'?");
}

TEST(TomlTable, RejectsOtherTypesAndRanges) {
    const TomlTable t = TomlTable::from_text(
        "a = \"5\"\nb = 2.5\nc = 11\nd = nan\ne = [1, 2]\nf = 1\n", "g");
    EXPECT_EQ(error_of([&] { t.number("a"); }), "g:1: 'a' must be a number");
    EXPECT_EQ(error_of([&] { t.integer("b", 0, 10); }),
              "g:2: 'b' must be a whole number");
    EXPECT_EQ(error_of([&] { t.integer("c", 0, 10); }),
              "g:3: 'c' is 11, but must be between 0 and 10");
    EXPECT_EQ(error_of([&] { t.number("d"); }), "g:4: 'd' must be a number");
    EXPECT_EQ(error_of([&] { t.vector("e"); }), "g:5: 'e' must be [x, y, z]");
    EXPECT_EQ(error_of([&] { t.table("f"); }), "g:6: 'f' must be a table");
}

TEST(TomlTable, SuggestsTheNearestChoice) {
    const TomlTable t = TomlTable::from_text("blend = \"option\"\n", "g");
    const std::string_view names[] = {"option1", "position"};
    EXPECT_EQ(error_of([&] { t.choice("blend", names); }),
              "g:1: unknown blend 'option', did you mean 'option1'?; one of: "
              "option1, position");
}

constexpr std::string_view kLists =
    "keys = [{t = 0}, {t = 1}]\n"
    "[[colliders]]\n"
    "radius = 9\n"
    "[[colliders]]\n"
    "radius = 2\n"
    "raduis = 3\n";

TEST(TomlTable, ReadsListsOfTablesInTheirOrder) {
    const TomlTable t = TomlTable::from_text(kLists, "g");
    ASSERT_EQ(t.tables("keys").size(), 2u);
    EXPECT_EQ(t.tables("keys")[0].number("t"), 0);
    EXPECT_EQ(t.tables("keys")[1].number("t"), 1);
    ASSERT_EQ(t.tables("colliders").size(), 2u);
    EXPECT_EQ(t.tables("colliders")[0].number("radius"), 9);
    EXPECT_EQ(t.tables("colliders")[1].number("radius"), 2);
    EXPECT_TRUE(t.tables("absent").empty());
    EXPECT_TRUE(TomlTable::from_text("keys = []\n", "g").tables("keys").empty());
}

TEST(TomlTable, NamesTheLineOfAnUnreadKeyInAListOfTables) {
    const TomlTable t = TomlTable::from_text(kLists, "g");
    EXPECT_EQ(error_of([&] { t.finish(); }), "g:2: unknown key 'colliders'; known: ");
    for (const TomlTable& key : t.tables("keys")) key.number("t");
    for (const TomlTable& collider : t.tables("colliders")) collider.number("radius");
    EXPECT_EQ(error_of([&] { t.finish(); }),
              "g:6: unknown key 'raduis' in [[colliders]], did you mean 'radius'?");
}

TEST(TomlTable, AMissingKeyInAListNamesTheLineOfItsTable) {
    const TomlTable t = TomlTable::from_text(kLists, "g");
    EXPECT_EQ(error_of([&] { t.tables("colliders")[1].fail("shape", "needs 'shape'"); }),
              "g:4: needs 'shape'");
}

TEST(TomlTable, RejectsListsOfOtherTypes) {
    const TomlTable t =
        TomlTable::from_text("a = 1\nb = [{x = 1}, 2]\n[c]\nx = 1\n", "g");
    EXPECT_EQ(error_of([&] { t.tables("a"); }),
              "g:1: 'a' must be a list of tables, [[a]]");
    EXPECT_EQ(error_of([&] { t.tables("b"); }),
              "g:2: 'b' must contain only tables, but item 2 is none");
    EXPECT_EQ(error_of([&] { t.tables("c"); }),
              "g:3: 'c' must be a list of tables, [[c]]");
}

TEST(TomlTable, SyntaxErrorsNameTheLine) {
    EXPECT_THAT(error_of([] { TomlTable::from_text("a = 1\nb = = 2\n", "g"); }),
                testing::StartsWith("g:2: "));
    EXPECT_THAT(error_of([] { TomlTable::from_file("/nowhere/g.toml"); }),
                testing::HasSubstr("cannot be opened"));
}

}  // namespace
}  // namespace lancret
