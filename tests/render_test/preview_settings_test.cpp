#include "render_test/preview_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/guides/temporary_folder.h"

namespace lancret {
namespace {

std::string error_of(std::string_view text) {
    return input_error([&] {
        const TomlTable toml = TomlTable::from_text(text, "g.toml");
        read_preview_settings(toml, Vec3f::UnitY());
        toml.finish();
    });
}

TEST(PreviewSettings, LightsThatWouldDoNothingAreErrors) {
    EXPECT_EQ(
        error_of("[light]\nstrength = 2\n"),
        "g.toml:2: 'strength' is that of a 'sky', 'environment' or 'key'; name one");
    EXPECT_EQ(error_of("[light]\nsky = [1, 1, 1]\nrotation_degrees = 9\n"),
              "g.toml:3: 'rotation_degrees' turns an 'environment'; name one");
    EXPECT_EQ(
        error_of("[light]\nkey_radius_degrees = 9\n"),
        "g.toml:2: 'key_radius_degrees' belongs to a 'key' or 'key_direction'; name one");
}

TEST(PreviewSettings, StrengthTimesTheSkyIsTheRadianceSeen) {
    const TomlTable toml =
        TomlTable::from_text("[light]\nsky = [1, 2, 3]\nstrength = 2\n", "g.toml");
    const PreviewSettings settings = read_preview_settings(toml, Vec3f::UnitY());
    ASSERT_TRUE(settings.lights);
    EXPECT_LT((settings.lights->radiance(Vec3f::UnitX()) - Vec3f(2, 4, 6)).norm(), 1e-6f);
}

TEST(PreviewSettings, RegularisationIsOnUnlessSaidOtherwise) {
    const auto later = [](std::string_view text) {
        const TomlTable toml = TomlTable::from_text(text, "g.toml");
        return later_hair(read_preview_settings(toml, Vec3f::UnitY()));
    };
    EXPECT_TRUE(later(""));
    EXPECT_FALSE(later("[render]\nregularisation = 0\n"));
    // N of the roughness asked for.
    HairMaterial rough;
    rough.beta_m = rough.beta_n = 0.75f;
    EXPECT_EQ(later("[render]\nregularisation = 0.75\n")->s, HairModel(rough).s);
    EXPECT_THAT(error_of("[render]\nregularisation = 1.5\n"),
                testing::StartsWith("g.toml:2: 'regularisation'"));
}

TEST(PreviewSettings, AShutterIsTwoFramesInOrder) {
    const TomlTable toml = TomlTable::from_text(
        "[render]\nshutter = [-0.25, 0.5]\nmotion_samples = 5\n", "g.toml");
    const PreviewSettings settings = read_preview_settings(toml, Vec3f::UnitY());
    EXPECT_EQ(settings.shutter, Vec2(-0.25, 0.5));
    EXPECT_EQ(settings.motion_samples, 5);
    using testing::StartsWith;
    EXPECT_EQ(error_of("[render]\nshutter = 0.5\n"),
              "g.toml:2: 'shutter' must be [a, b], two numbers");
    for (const char* wrong : {"[1, 0]", "[0, 2000]"}) {
        EXPECT_THAT(error_of(std::string("[render]\nshutter = ") + wrong + "\n"),
                    StartsWith("g.toml:2: 'shutter' is [opens, closes]"));
    }
    EXPECT_NE(error_of("[render]\nmotion_samples = 1\n"), "");
}

}  // namespace
}  // namespace lancret
