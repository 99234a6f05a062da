// Check views and contact sheets.

#include <functional>
#include <nlohmann/json.hpp>

#include "guides/files/frame_store.h"
#include "render_test/image/contact_sheet.h"
#include "tests/tools/reports.h"
#include "tests/tools/small_grooms.h"
#include "tests/tools/view_layers.h"

namespace lancret {
namespace {

using testing::HasSubstr;

/// Runs preview --view and returns the view from its --stats.
nlohmann::json view_stats(const SmallGrooms& folder, std::vector<std::string> words) {
    words.insert(words.begin(), "preview");
    for (const char* word : {"--size", "40x40", "--samples", "1", "-o"}) {
        words.emplace_back(word);
    }
    words.push_back(folder.at("view.exr"));
    words.emplace_back("--stats");
    words.push_back(folder.at("view.json"));
    EXPECT_THAT(lancret(words), works());
    return json_of(folder.at("view.json"))["view"];
}

TEST(Views, ErrorsEqualThoseOfCheck) {
    const SmallGrooms folder;
    for (const char* blend : {"detail", "position"}) {
        const std::string report = folder.at("report.json");
        lancret({"check", folder.made, "--blend", blend, "--json", report});
        const auto check = json_of(report);
        const auto length =
            view_stats(folder, {folder.made, "--blend", blend, "--view", "length-error"});
        EXPECT_EQ(length["largest"], check["length"]["max_relative_error"]) << blend;
        EXPECT_EQ(length["above"] == 0, std::string(blend) == "detail");
        EXPECT_EQ(length["high"], float(1e-5));
        const auto frames = view_stats(
            folder, {folder.made, "--blend", blend, "--view", "orthogonality"});
        EXPECT_EQ(frames["largest"], check["orthogonality"]["max"]) << blend;
        EXPECT_EQ(frames["above"], 0);
    }
}

TEST(Views, EachHasADifferentPicture) {
    const SmallGrooms folder;
    const std::string painted = folder.file(
        "painted.toml", read_bytes(folder.made) + "[regions]\nids = \"ids.txt\"\n");
    std::string ids;
    for (int i = 0; i < 40; ++i) ids += i % 2 ? "3\n" : "5\n";
    folder.file("ids.txt", ids);
    std::vector<std::string> pictures;
    for (const char* view : {"length-error", "orthogonality", "curvature", "torsion",
                             "influence", "region", "penetration"}) {
        const std::string png = folder.at("view.png");
        ASSERT_THAT(
            lancret({"preview", painted, "--view", view, "-o", png, "--size", "120x120"}),
            works());
        pictures.push_back(read_bytes(png));
        EXPECT_EQ(std::ranges::count(pictures, pictures.back()), 1) << view;
    }
}

/// Appends a box whose triangles face outward.
void add_box(TriangleMesh& mesh, const Vec3f& low, const Vec3f& high) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (int i = 0; i < 8; ++i) {
        mesh.positions.emplace_back(i & 1 ? high.x() : low.x(),
                                    i & 2 ? high.y() : low.y(),
                                    i & 4 ? high.z() : low.z());
    }
    constexpr std::uint32_t kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& s : kSides) {
        mesh.triangles.push_back({first + s[0], first + s[1], first + s[2]});
        mesh.triangles.push_back({first + s[0], first + s[2], first + s[3]});
    }
}

TEST(Views, PenetrationShowsOnlyStrandsThatRunThroughABody) {
    // Straight hairs on the square [0, 4]^2, and a box over its half x < 2 from z = 2 to
    // 3: hairs with roots there are 0.5 cm deep inside, or less near x = 2.
    const SmallGrooms folder;
    std::vector<Vec3f> roots;
    for (int i = 0; i < 64; ++i) {
        roots.emplace_back(0.25f + 0.5f * float(i % 8), 0.25f + 0.5f * float(i / 8),
                           0.0f);
    }
    const std::string hair = folder.at("straight.hair"), obj = folder.at("box.obj");
    write_hair(hair, straight_hairs(roots, Vec3f(0, 0, 5), 9));
    TriangleMesh mesh = square_mesh(4, 3);
    mesh.uvs.clear();
    add_box(mesh, Vec3f(-1, -1, 2), Vec3f(2, 5, 3));
    write_obj(obj, mesh);
    const std::vector<std::string> groom{
        hair, "--scalp", obj, "--guides", "64", "--strands", "200", "--intervals", "32"};
    std::vector<std::string> words = groom;
    words.insert(words.begin(), "expand");
    words.insert(words.end(), {"-o", folder.at("children.hair")});
    ASSERT_THAT(lancret(words), works());
    const Strands children = read_hair(folder.at("children.hair"));
    words = groom;
    words.insert(words.end(), {"--view", "penetration"});
    const auto view = view_stats(folder, words);

    // Strands are sampled every 5 / 64 cm: the deepest sample is at most half of that
    // from the middle of the box.
    std::size_t within = 0;
    float deepest = 0;
    for (std::size_t i = 0; i < children.size(); ++i) {
        const float depth = std::min(0.5f, 2 - children.points[children.first[i]].x());
        within += depth > 1e-3f;
        deepest = std::max(deepest, depth);
    }
    ASSERT_GT(within, 50u);
    ASSERT_LT(within, 150u);
    EXPECT_EQ(view["above"], within);
    EXPECT_NEAR(view["largest"], deepest, 2.5 / 64);
    const Layers picture = read_layers(folder.at("view.exr"));
    std::size_t clean = 0, pierced = 0;
    for (std::size_t i = 0; i < picture.id.size(); ++i) {
        if (picture.id[i] >= children.size()) continue;
        const float x = children.points[children.first[picture.id[i]]].x();
        const float depth = std::max(0.0f, std::min(0.5f, 2 - x));
        EXPECT_NEAR(picture.value[i], depth, 2.5f / 64) << picture.id[i];
        EXPECT_EQ(picture.value[i] > 1e-3f, x < 2 - 1e-3f) << picture.id[i];
        ++(x < 2 ? pierced : clean);
    }
    EXPECT_GT(clean, 0u);
    EXPECT_GT(pierced, 0u);
}

TEST(Views, UseTheRequestedRange) {
    const SmallGrooms folder;
    const auto view =
        view_stats(folder, {folder.made, "--view", "curvature", "--view-range", "0.5,2"});
    EXPECT_EQ(view["low"], 0.5);
    EXPECT_EQ(view["high"], 2);
    const auto own = view_stats(folder, {folder.made, "--view", "curvature"});
    EXPECT_EQ(own["low"], 0);
    EXPECT_LE(own["high"], own["largest"]);
    EXPECT_EQ(own["largest"], view["largest"]);
}

TEST(Views, InvalidOnesAreRefused) {
    const SmallGrooms folder;
    const auto ask = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "preview");
        words.insert(words.end(), {"--size", "8x8", "-o", folder.at("no.png")});
        return lancret(words);
    };
    EXPECT_THAT(ask({folder.made, "--view", "beauty"}),
                refuses_with("--view: ", "torsion"));
    EXPECT_THAT(ask({folder.made, "--view", "region"}),
                refuses_with("--view region: ", "has no regions"));
    EXPECT_THAT(ask({folder.made, "--view", "torsion", "--blend", "position"}),
                refuses_with("--view torsion: ", "position"));
    EXPECT_THAT(ask({folder.hair, "--view", "penetration"}),
                refuses_with("--view penetration: ", "--scalp"));
    // Different as doubles but not as floats.
    for (const char* range : {"0,1e-60", "1,1.00000000001", "-1e39,1e39"}) {
        EXPECT_THAT(ask({folder.made, "--view", "curvature", "--view-range", range}),
                    refuses_with("--view-range: ", ""));
    }
    for (const char* range : {"1", "2,1", "0,nan", "0,inf", "a,b", "1,1"}) {
        EXPECT_THAT(ask({folder.made, "--view", "curvature", "--view-range", range}),
                    refuses_with("--view-range: ", range));
    }
    EXPECT_THAT(ask({folder.made, "--view", "influence", "--view-range", "0,1"}),
                refuses_with("--view-range: ", "influence"));
    for (const char* range : {"0,1", "1e-60,1"}) {
        EXPECT_THAT(ask({folder.made, "--view", "length-error", "--view-range", range}),
                    refuses_with("--view-range: ", "logarithmic"));
    }
    const std::string deep = folder.at("deep.exr");
    for (const std::vector<std::string>& light : std::vector<std::vector<std::string>>{
             {"--deep", deep}, {"--denoise"}, {"--draft"}, {"--noise", "0.1"}}) {
        std::vector<std::string> words{folder.made, "--view", "curvature"};
        words.insert(words.end(), light.begin(), light.end());
        EXPECT_THAT(ask(words), refuses_with(light[0] + ": ", "--view curvature"));
    }
    EXPECT_FALSE(std::filesystem::exists(deep));
    EXPECT_EQ(ask({folder.made, "--view-range", "0,1"}).exit_code, 2);
    EXPECT_EQ(ask({folder.made, "--view", "curvature", "--shutter", "0,1"}).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "no.png"));
}

/// Width and height from a PNG header, big-endian from byte 16 on.
std::pair<int, int> size_of_png(const std::string& path) {
    const std::string bytes = read_bytes(path);
    const auto number = [&](std::size_t at) {
        int out = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            out = out << 8 | std::uint8_t(bytes.at(at + i));
        }
        return out;
    };
    return {number(16), number(20)};
}

TEST(ContactSheet, ShowsThePicturesOfATurntable) {
    const SmallGrooms folder;
    const std::string sheet = folder.at("sheet.png");
    ASSERT_THAT(lancret({"preview", folder.made, "--turntable", "6", "-o",
                         folder.at("t.#.png"), "--contact-sheet", sheet}),
                works());
    for (int i = 1; i <= 6; ++i) {
        EXPECT_TRUE(
            std::filesystem::exists(folder / ("t." + std::to_string(i) + ".png")));
    }
    const Image image = make_contact_sheet(6, 32, 32, Vec3f::Zero()).image;
    EXPECT_EQ(size_of_png(sheet), std::pair(image.width, image.height));
}

TEST(ContactSheet, OfOnePictureOrOverAnotherOutputIsRefused) {
    const SmallGrooms folder;
    EXPECT_THAT(lancret({"preview", folder.made, "-o", folder.at("a.png"),
                         "--contact-sheet", folder.at("b.png")}),
                refuses_with("--contact-sheet: ", "--turntable"));
    EXPECT_THAT(lancret({"preview", folder.made, "--turntable", "2", "-o",
                         folder.at("a.#.png"), "--contact-sheet", folder.at("a.2.png")}),
                refuses_with("cannot hold two outputs"));
    EXPECT_THAT(lancret({"preview", folder.made, "--turntable", "2", "-o",
                         folder.at("a.#.png"), "--contact-sheet", folder.at("b.exr")}),
                refuses_with("b.exr", ".png"));
}

TEST(StillFrames, AreGrownAndRenderedOnce) {
    const SmallGrooms folder;
    const std::string fit = folder.at("fit.h5"), cache = folder.at("cache.h5");
    ASSERT_THAT(lancret({"fit", folder.made, "-o", fit}), works());
    const Guides rest = read_guide_cache(fit, 0);
    Guides bent = rest;
    for (Vec3& u : bent.curvatures) u.z() += 0.05;
    {
        FrameStore store(cache, {24, 1, folder.made}, "still", rest, true);
        for (const bool is_bent : {false, false, true, true, false}) {
            store.add(is_bent ? bent : rest, {});
        }
        store.finish();
    }
    ASSERT_THAT(
        lancret({"preview", cache, "--frames", "1-5", "-o", folder.at("f.#.png"),
                 "--deep", folder.at("d.#.exr"), "--stats", folder.at("stats.json"),
                 "--contact-sheet", folder.at("sheet.png")}),
        works());
    const auto frames = json_of(folder.at("stats.json"))["frames"];
    ASSERT_EQ(frames.size(), 5u);
    const bool still[] = {false, true, false, true, false};
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(frames[i]["still"], still[i]) << i;
        EXPECT_EQ(frames[i]["seconds"]["bvh"] == 0, still[i]) << i;
        EXPECT_EQ(frames[i]["seconds"]["render"] == 0, still[i]) << i;
    }
    const auto picture = [&](int i) {
        return read_bytes(folder / ("f." + std::to_string(i) + ".png"));
    };
    const auto deep = [&](int i) {
        return read_bytes(folder / ("d." + std::to_string(i) + ".exr"));
    };
    for (const auto& file : {std::function<std::string(int)>(picture),
                             std::function<std::string(int)>(deep)}) {
        EXPECT_EQ(file(2), file(1));
        EXPECT_NE(file(3), file(2));
        EXPECT_EQ(file(4), file(3));
        EXPECT_EQ(file(5), file(1));
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "sheet.png"));
}

TEST(StillFrames, DoNotIncludeThoseOfAMovingHead) {
    const SmallGrooms folder;
    const std::string toml =
        folder.file("moves.toml", read_bytes(folder.made) +
                                      "[motion]\nkeys = [{ frame = 1 }, { frame = 2 }, "
                                      "{ frame = 3, turn = [0, 30, 0] }]\n");
    const std::string fit = folder.at("fit.h5"), cache = folder.at("cache.h5");
    ASSERT_THAT(lancret({"fit", toml, "-o", fit}), works());
    const Guides rest = read_guide_cache(fit, 0);
    {
        FrameStore store(cache, {24, 1, toml}, "moves", rest, true);
        for (int i = 0; i < 3; ++i) store.add(rest, {});
        store.finish();
    }
    ASSERT_THAT(lancret({"preview", cache, "--frames", "1-3", "-o", folder.at("f.#.png"),
                         "--stats", folder.at("stats.json")}),
                works());
    const auto frames = json_of(folder.at("stats.json"))["frames"];
    EXPECT_EQ(frames[2]["still"], false);
    EXPECT_NE(read_bytes(folder / "f.3.png"), read_bytes(folder / "f.2.png"));
}

TEST(Evaluate, StripIsRegularisedLikeThePreview) {
    const SmallGrooms folder;
    const auto strip = [&](const char* setting) {
        const std::string toml =
            folder.file("groom.toml",
                        "[guides]\nsegments = 6\n[guides.made]\nstrands = 400\n"
                        "[material]\npreset = \"blond\"\n[width]\nroot = 0.1\n"
                        "[render]\n" +
                            std::string(setting));
        EXPECT_THAT(
            lancret({"evaluate", toml, "--blend", "position", "--image",
                     folder.at("strip.png"), "--size", "24x24", "--samples", "2"}),
            works());
        return read_bytes(folder / "strip.png");
    };
    const std::string usual = strip("");
    EXPECT_EQ(usual, strip("regularisation = 0.5\n"));
    EXPECT_NE(usual, strip("regularisation = 0\n"));
}

}  // namespace
}  // namespace lancret
