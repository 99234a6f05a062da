#include "render_test/image/contact_sheet.h"

#include <gtest/gtest.h>

#include "render_test/image/draw.h"

namespace lancret {
namespace {

Image plain(int width, int height, const Eigen::Vector4f& colour) {
    Image out(width, height);
    std::ranges::fill(out.rgba, colour);
    return out;
}

TEST(ContactSheet, HasAPlaceForEachPictureWithinItsBounds) {
    for (const std::size_t pictures :
         {1u, 2u, 5u, 12u, 48u, 96u, 240u, 256u, 257u, 5000u}) {
        for (const auto& [width, height] :
             {std::pair{640, 640}, {1920, 1080}, {32, 900}, {7, 5}, {16384, 1}}) {
            const ContactSheet sheet =
                make_contact_sheet(pictures, width, height, Vec3f::Zero());
            const std::size_t tiles = (pictures + sheet.every - 1) / sheet.every;
            EXPECT_LE(tiles, std::size_t(kMaxSheetTiles));
            EXPECT_GE(std::size_t(sheet.columns * sheet.rows), tiles);
            EXPECT_LT(std::size_t(sheet.columns * (sheet.rows - 1)), tiles);
            EXPECT_LE(sheet.columns, kMaxSheetColumns);
            EXPECT_LE(sheet.image.width, kMaxSheetSide);
            EXPECT_LE(sheet.image.height, kMaxSheetSide);
            EXPECT_LE(sheet.tile_width, width);
            EXPECT_LE(sheet.tile_height, height);
        }
    }
}

TEST(ContactSheet, EachPictureStandsInItsPlaceOverTheBackground) {
    ContactSheet sheet = make_contact_sheet(6, 800, 600, Vec3f::Constant(0.5f));
    for (std::size_t i = 0; i < 6; ++i) {
        add_picture(sheet, i, plain(800, 600, {0.1f * float(i), 0, 0, 0.5f}), "");
    }
    for (int i = 0; i < 6; ++i) {
        const int x = i % sheet.columns * (sheet.tile_width + kSheetGap);
        const int y = i / sheet.columns * (sheet.tile_height + kSheetGap);
        for (const auto& [dx, dy] :
             {std::pair{0, 0}, {sheet.tile_width - 1, sheet.tile_height - 1}}) {
            const auto& pixel =
                sheet.image.rgba[std::size_t(y + dy) * sheet.image.width + x + dx];
            // Half of the background shows; the weights of a mean sum to 1 up to
            // round-off.
            EXPECT_NEAR(pixel.x(), 0.1f * float(i) + 0.25f, 1e-5f) << i;
            EXPECT_NEAR(pixel.y(), 0.25f, 1e-5f) << i;
            EXPECT_EQ(pixel.w(), 1) << i;
        }
    }
}

TEST(ContactSheet, OfTooManyPicturesEveryNthIsThere) {
    ContactSheet sheet = make_contact_sheet(600, 40, 40, Vec3f::Zero());
    ASSERT_EQ(sheet.every, 3u);
    const Image before = sheet.image;
    add_picture(sheet, 1, plain(40, 40, {1, 1, 1, 1}), "");
    EXPECT_EQ(sheet.image.rgba, before.rgba);
    add_picture(sheet, 3, plain(40, 40, {1, 1, 1, 1}), "");
    const std::size_t second = std::size_t(sheet.tile_width + kSheetGap);
    EXPECT_NEAR(sheet.image.rgba[second].x(), 1, 1e-5f);
    EXPECT_EQ(sheet.image.rgba[second - 1].x(), 0);
}

TEST(ContactSheet, APictureIsReducedToItsMeans) {
    Image image(4, 2);
    for (int i = 0; i < 8; ++i) image.rgba[i].setConstant(float(i));
    const Image half = reduced(image, 2, 1);
    ASSERT_EQ(half.rgba.size(), 2u);
    EXPECT_NEAR(half.rgba[0].x(), (0 + 1 + 4 + 5) / 4.0f, 1e-5f);
    EXPECT_NEAR(half.rgba[1].w(), (2 + 3 + 6 + 7) / 4.0f, 1e-5f);
}

TEST(DrawText, ThatLeavesThePictureIsCutAtItsEdge) {
    Image whole(200, 60), cut(40, 60);
    if (!draw_text(whole, 10, 30, "orthogonality", 16, Vec3f::Ones())) {
        GTEST_SKIP() << "no font here";
    }
    EXPECT_TRUE(draw_text(cut, 10, 30, "orthogonality", 16, Vec3f::Ones()));
    float ink = 0;
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 40; ++x) {
            EXPECT_EQ(cut.rgba[y * 40 + x], whole.rgba[y * 200 + x]) << x << ' ' << y;
            ink += cut.rgba[y * 40 + x].x();
        }
    }
    EXPECT_GT(ink, 10);
    for (const auto& [x, y] : {std::pair{300, 30}, {-500, 30}, {10, -90}, {10, 400}}) {
        const Image before = cut;
        draw_text(cut, x, y, "orthogonality", 16, Vec3f::Ones());
        EXPECT_EQ(cut.rgba, before.rgba) << x << ' ' << y;
    }
}

}  // namespace
}  // namespace lancret
