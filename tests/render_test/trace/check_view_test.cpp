#include "render_test/trace/check_view.h"

#include <gtest/gtest.h>

#include "render_test/image/colour_scale.h"
#include "render_test/image/draw.h"
#include "render_test/trace/legend.h"
#include "render_test/trace/render.h"
#include "tests/render_test/make_curves.h"

namespace lancret {
namespace {

/// A ribbon along x from -4 (root) to 4 (tip), a metre wide, over a ground at z = -1, and
/// a camera far above that sees two millimetres of it about x = `x`.
struct Ribbon {
    Curves curves;
    TriangleMesh ground;
    HairScene geometry;
    CheckView view;
    RenderScene scene;
    RenderSettings settings;

    static Curves strand(float z) {
        std::vector<Vec3f> row;
        for (int i = 0; i <= 8; ++i) row.push_back(Vec3f(float(i - 4), 0, z));
        return curves_through({row}, 50);
    }
    static TriangleMesh plane() {
        TriangleMesh out;
        out.positions = {{-900, -900, -1}, {900, -900, -1}, {0, 1800, -1}};
        out.triangles = {{0, 1, 2}};
        return out;
    }
    explicit Ribbon(float z = 0)
        : curves(strand(z)), ground(plane()), geometry(curves, &ground) {
        view.values = {true, {1, 3}, {0, 2}};
        view.scale.low = 0;
        view.scale.high = 4;
        scene.geometry = &geometry;
        scene.view = &view;
        settings.width = settings.height = 3;
        settings.samples = 4;
    }
    Image image(float x) const {
        return render(
            scene, look_at(Vec3f(x, 0, 1000), Vec3f(x, 0, 0), Vec3f::UnitY(), 2e-4f, 1),
            settings);
    }
};

// Within a millimetre of the middle of a ribbon a metre wide |h| < 2e-3, which darkens it
// by 2e-6. Along x the value changes by at most 0.1 * 2 / 8, or 0.0063 of the scale,
// whose colours change by less than 4 per unit.
constexpr float kAlong = 0.03f;

TEST(CheckView, AStrandFacingTheCameraHasTheColourOfItsValue) {
    const Ribbon ribbon;
    for (const float x : {-3.0f, 0.0f, 2.0f}) {
        const float value = 1 + 2 * (x + 4) / 8;
        const Image image = ribbon.image(x);
        for (std::size_t i = 0; i < 9; ++i) {
            const Vec3f colour = image.rgba[i].head<3>();
            EXPECT_LT((colour - sequential_colour(value / 4)).norm(), kAlong) << x;
            EXPECT_NEAR(image.value[i], value, 0.03f) << x;
            EXPECT_EQ(image.rgba[i].w(), 1) << x;
            EXPECT_EQ(image.id[i], 0u);
        }
    }
}

TEST(CheckView, ValuesBeyondTheLimitAreRed) {
    Ribbon ribbon;
    ribbon.view.scale.high = 2;
    ribbon.view.scale.over = "fails";
    EXPECT_LT((ribbon.image(-2).rgba[4].head<3>() - sequential_colour(0.75f)).norm(),
              kAlong);
    EXPECT_LT((ribbon.image(2).rgba[4].head<3>() - kFailColour).norm(), 1e-5f);
}

TEST(CheckView, AStrandOfACategoryHasItsColour) {
    Ribbon ribbon;
    ribbon.view.colours = {Vec3f(0.1f, 0.5f, 0.3f)};
    EXPECT_LT((ribbon.image(0).rgba[4].head<3>() - ribbon.view.colours[0]).norm(), 1e-5f);
}

TEST(CheckView, AStrandSeenLengthwiseIsDarkerByMinShade) {
    const Ribbon ribbon;
    Hit hit;
    hit.strand.facing = Vec3f::UnitZ();
    Ray ray;
    ray.direction = Vec3f::UnitX();
    RayCounter counter{ribbon.geometry};
    const Vec3f along = view_radiance(ribbon.view, ray, hit, counter);
    ray.direction = -Vec3f::UnitZ();
    const Vec3f across = view_radiance(ribbon.view, ray, hit, counter);
    EXPECT_LT((along - kMinShade * across).norm(), 1e-6f);
    EXPECT_EQ(counter.rays, 0u);
}

TEST(CheckView, StrandsBelowASurfaceShowThroughUnlessClean) {
    Ribbon ribbon(-2);  // the ground is at -1
    const Vec3f ground = ribbon.image(0).rgba[4].head<3>();
    EXPECT_EQ(ground.x(), ground.y());  // grey
    ribbon.view.scale.clean = 1.5f;
    ribbon.view.apart = strands_apart(ribbon.view, ribbon.curves, &ribbon.ground);
    EXPECT_LT((ribbon.image(-3).rgba[4].head<3>() - ground).norm(), 1e-6f);
    const Vec3f below = 0.6f * sequential_colour(2.5f / 4) + 0.4f * ground;
    EXPECT_LT((ribbon.image(2).rgba[4].head<3>() - below).norm(), kAlong);
}

TEST(CheckView, CleanStrandsAreGrey) {
    Ribbon ribbon;
    ribbon.view.scale.clean = 1.5f;
    EXPECT_LT((ribbon.image(-3).rgba[4].head<3>() - kCleanColour).norm(), 1e-5f);
}

TEST(CheckView, ALogarithmicScaleGivesEachDecadeTheSameRoom) {
    ColourScale scale;
    scale.kind = ColourScale::Kind::logarithmic;
    scale.low = 1e-9f;
    scale.high = 1e-5f;
    for (int i = 0; i <= 4; ++i) {
        // Rounding of the values to float changes their logarithm by 6e-8 of 9.2.
        EXPECT_NEAR(scale_place(scale, float(std::pow(10, i - 9))), 0.25f * float(i),
                    1e-7f);
    }
    EXPECT_EQ(scale_place(scale, 0), 0);
    EXPECT_EQ(scale_place(scale, 1), 1);
}

TEST(Legend, ItsBarIsTheScaleFromLeftToRight) {
    for (const auto kind : {ColourScale::Kind::sequential, ColourScale::Kind::diverging,
                            ColourScale::Kind::logarithmic}) {
        CheckView view;
        view.title = "curvature, 1/cm";
        view.scale.kind = kind;
        view.scale.low = 0.01f;
        view.values.values = {0.5f};
        for (const int size : {20, 240}) {
            Image image(size, size);
            draw_legend(image, view);
            const LegendLayout at = legend_layout(size, size);
            ASSERT_LE(at.bar_y + at.bar_height, size);
            for (int i = 0; i < at.bar_width; ++i) {
                const auto& pixel =
                    image.rgba[std::size_t(at.bar_y) * size + at.bar_x + i];
                const Vec3f colour =
                    scale_colour_at(view.scale, (float(i) + 0.5f) / float(at.bar_width));
                EXPECT_EQ(Vec3f(pixel.head<3>()), colour) << size << ' ' << i;
                EXPECT_EQ(pixel.w(), 1);
            }
            // Above the band the picture is unchanged.
            EXPECT_EQ(image.rgba[0], Eigen::Vector4f::Zero());
        }
    }
}

TEST(Legend, NamesAreWrittenAndSwatchesShown) {
    CheckView view;
    view.colours = {Vec3f::Ones()};
    view.swatches = {{"", Vec3f(0.1f, 0.5f, 0.3f)}, {"", Vec3f(0.7f, 0.2f, 0.3f)}};
    const auto drawn = [&] {
        Image image(240, 240);
        draw_legend(image, view);
        return image;
    };
    const Image mute = drawn();
    for (const Swatch& swatch : view.swatches) {
        std::size_t pixels = 0;
        for (const auto& pixel : mute.rgba) {
            pixels += Vec3f(pixel.head<3>()) == swatch.colour;
        }
        const int side = legend_layout(240, 240).bar_height;
        EXPECT_EQ(pixels, std::size_t(side) * side);
    }
    Image page(32, 32);
    if (!draw_text(page, 4, 20, "x", 12, Vec3f::Ones())) GTEST_SKIP() << "no font here";
    view.title = "region";
    const Image titled = drawn();
    EXPECT_NE(titled.rgba, mute.rgba);
    view.swatches[1].name = "12";
    EXPECT_NE(drawn().rgba, titled.rgba);
}

}  // namespace
}  // namespace lancret
