#include "render_test/settings/preview.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

std::string error_of(std::string_view text) {
    return input_error([&] {
        const TomlTable toml = TomlTable::from_text(text, "g.toml");
        read_preview_settings(toml, Vec3f::UnitY());
        toml.finish();
    });
}

TEST(PreviewSettings, IneffectiveLightSettingsAreErrors) {
    EXPECT_EQ(error_of("[light]\nstrength = 2\n"),
              "g.toml:2: 'strength' needs a 'sky', 'environment' or 'key'");
    EXPECT_EQ(error_of("[light]\nsky = [1, 1, 1]\nrotation_degrees = 9\n"),
              "g.toml:3: 'rotation_degrees' needs an 'environment'");
    EXPECT_EQ(error_of("[light]\nkey_radius_degrees = 9\n"),
              "g.toml:2: 'key_radius_degrees' needs a 'key' or 'key_direction'");
}

TEST(PreviewSettings, StrengthTimesTheSkyIsTheRadianceSeen) {
    const TomlTable toml =
        TomlTable::from_text("[light]\nsky = [1, 2, 3]\nstrength = 2\n", "g.toml");
    const PreviewSettings settings = read_preview_settings(toml, Vec3f::UnitY());
    ASSERT_TRUE(settings.lights);
    EXPECT_LT((settings.lights->radiance(Vec3f::Zero(), Vec3f::UnitX()) - Vec3f(2, 4, 6))
                  .norm(),
              1e-6f);
}

PreviewSettings settings_of(std::string_view text) {
    const TomlTable toml = TomlTable::from_text(text, "g.toml");
    PreviewSettings settings = read_preview_settings(toml, Vec3f::UnitY());
    toml.finish();
    return settings;
}

TEST(PreviewSettings, LightsOfEachKindShineFromTheirPlace) {
    const PreviewSettings settings = settings_of(R"(
        [light]
        strength = 2
        [[light.distant]]
        direction = [1, 0, 0]
        irradiance = [1, 2, 3]
        radius_degrees = 45
        [[light.rectangle]]
        position = [0, 10, 0]
        target = [0, 0, 0]
        size = [4, 2]
        radiance = [1, 0, 0]
        [[light.sphere]]
        position = [0, 0, 10]
        radius = 2
        radiance = [0, 1, 0]
    )");
    ASSERT_TRUE(settings.lights);
    const auto seen = [&](const Vec3f& direction) {
        return settings.lights->radiance(Vec3f::Zero(), direction);
    };
    EXPECT_EQ(seen(Vec3f::UnitY()), Vec3f(2, 0, 0));
    EXPECT_EQ(seen(Vec3f::UnitZ()), Vec3f(0, 2, 0));
    EXPECT_EQ(seen(-Vec3f::UnitY()), Vec3f::Zero());  // no sky beside them
    // Irradiance 2 over pi sin^2(45 degrees).
    EXPECT_NEAR(seen(Vec3f::UnitX()).x(), 2 / (M_PI / 2), 1e-5);
}

TEST(PreviewSettings, RectangleAndSphereNeedAPlace) {
    EXPECT_EQ(error_of("[[light.sphere]]\nradius = 2\n"),
              "g.toml:1: a sphere of light needs a 'position'");
    EXPECT_EQ(error_of("[[light.rectangle]]\nposition = [0, 1, 0]\n"),
              "g.toml:1: a rectangle of light needs a 'target', the point that it faces");
    EXPECT_EQ(error_of("[[light.rectangle]]\nposition = [0, 1, 0]\n"
                       "target = [0, 1, 0]\n"),
              "g.toml:3: 'target' must not be the light's 'position'");
}

TEST(PreviewSettings, PresetsAreTheMelaninOfTheirName) {
    EXPECT_EQ(settings_of("[material]\npreset = \"blond\"\n").hair.eumelanin, 0.3f);
    EXPECT_EQ(settings_of("[material]\npreset = \"brown\"\n").hair.eumelanin, 1.3f);
    EXPECT_EQ(settings_of("[material]\npreset = \"black\"\n").hair.eumelanin, 8);
    EXPECT_EQ(error_of("[material]\npreset = \"black\"\neumelanin = 1\n"),
              "g.toml:2: a 'preset' sets the melanin: remove 'eumelanin' and 'colour'");
    EXPECT_EQ(error_of("[material]\npreset = \"blonde\"\n"),
              "g.toml:2: unknown preset 'blonde', did you mean 'blond'?; one of: "
              "blond, brown, black");
}

TEST(PreviewSettings, MaterialSetsHowStrandsDiffer) {
    const PreviewSettings settings = settings_of(
        "[material]\nmelanin_variation = 0.3\nroughness_variation = 0.2\nseed = 7\n"
        "root_colour = [0.1, 0.05, 0.02]\ntip_colour = [0.5, 0.4, 0.3]\n"
        "shading = \"groom\"\n");
    EXPECT_EQ(settings.hair.melanin_variation, 0.3f);
    EXPECT_EQ(settings.hair.roughness_variation, 0.2f);
    EXPECT_EQ(settings.hair.seed, 7u);
    EXPECT_EQ(settings.hair.root_colour, Vec3f(0.1f, 0.05f, 0.02f));
    EXPECT_EQ(settings.hair.tip_colour, Vec3f(0.5f, 0.4f, 0.3f));
    EXPECT_TRUE(settings.render.path.groom_shading);
    EXPECT_NE(error_of("[material]\nmelanin_variation = 2\n"), "");
}

/// Rows of a matrix in TOML.
std::string rows(const Eigen::Matrix4d& m) {
    std::string out = "[";
    for (int r = 0; r < 4; ++r) {
        out += r ? ", [" : "[";
        for (int c = 0; c < 4; ++c) {
            out += (c ? ", " : "") + fmt::format("{:.17g}", m(r, c) + 0.0);
        }
        out += "]";
    }
    return out + "]";
}

TEST(PreviewSettings, MatricesOfUsdAndOpenExrPlaceTheSameCamera) {
    const Camera camera =
        look_at(Vec3f(3, 4, 50), Vec3f(0, 1, 0), Vec3f::UnitY(), 0.5236f, 1);
    Eigen::Matrix4d to_world = Eigen::Matrix4d::Identity();
    to_world.topLeftCorner<3, 3>() = camera.frame.cast<double>();
    to_world.topRightCorner<3, 1>() = camera.position.cast<double>();
    // USD: camera to world for row vectors. OpenEXR: world to a camera that looks along
    // +z, for row vectors: z of a point is its distance in front.
    Eigen::Matrix4d exr = to_world.inverse();
    exr.row(2) *= -1;
    const Eigen::Vector4d target = exr * Eigen::Vector4d(0, 1, 0, 1);
    EXPECT_NEAR(target.z(), (Vec3(3, 4, 50) - Vec3(0, 1, 0)).norm(), 1e-4);
    const Eigen::AlignedBox3f box(Vec3f(-5, -5, -5), Vec3f(5, 5, 5));
    for (const std::string& text : {"matrix = " + rows(to_world.transpose()),
                                    "world_to_camera = " + rows(exr.transpose())}) {
        const PreviewSettings settings = settings_of("[camera]\n" + text + "\n");
        const Camera made = preview_camera(settings, box, Vec3f::UnitY());
        EXPECT_LT((made.frame - camera.frame).norm(), 1e-5f) << text;
        EXPECT_LT((made.position - camera.position).norm(), 1e-4f);
        EXPECT_EQ(made.lens_radius, 0);
    }
    EXPECT_EQ(error_of("[camera]\nmatrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]\n"),
              "g.toml:2: 'matrix' must be four rows of four numbers");
    EXPECT_EQ(
        error_of("[camera]\nmatrix = " + rows(to_world) + "\n"),
        "g.toml:2: a camera's matrix must be a right-handed rotation, a translation and "
        "at most a uniform scale");
    EXPECT_EQ(error_of("[camera]\nposition = [0, 0, 9]\nmatrix = " +
                       rows(to_world.transpose()) + "\n"),
              "g.toml:2: a camera with a matrix cannot have another position");
}

TEST(PreviewSettings, AStopOpensTheLensAndTheTargetIsInFocus) {
    const Eigen::AlignedBox3f box(Vec3f(-5, -5, -5), Vec3f(5, 5, 5));
    const Camera camera =
        preview_camera(settings_of("[camera]\nposition = [0, 0, 30]\nf_stop = 2\n"), box,
                       Vec3f::UnitY());
    EXPECT_EQ(camera.lens_radius, lens_radius_of(2, 0.5236f));
    EXPECT_EQ(camera.focus_distance, 30);
    const Camera nearer = preview_camera(
        settings_of("[camera]\nposition = [0, 0, 30]\nf_stop = 2\nfocus_distance = 25\n"),
        box, Vec3f::UnitY());
    EXPECT_EQ(nearer.focus_distance, 25);
    EXPECT_EQ(error_of("[camera]\nfocus_distance = 25\n"),
              "g.toml:2: 'focus_distance' needs an 'f_stop'");
}

TEST(PreviewSettings, RegularisationIsOnByDefault) {
    const auto later = [](std::string_view text) {
        const TomlTable toml = TomlTable::from_text(text, "g.toml");
        return later_hair(read_preview_settings(toml, Vec3f::UnitY()));
    };
    EXPECT_TRUE(later(""));
    EXPECT_FALSE(later("[render]\nregularisation = 0\n"));
    // N of the requested roughness.
    HairMaterial rough;
    rough.beta_m = rough.beta_n = 0.75f;
    EXPECT_EQ(later("[render]\nregularisation = 0.75\n")->model(0).s, HairModel(rough).s);
    EXPECT_THAT(error_of("[render]\nregularisation = 1.5\n"),
                testing::StartsWith("g.toml:2: 'regularisation'"));
}

TEST(PreviewSettings, LobesAreAutomaticByDefault) {
    const auto lobes = [](std::string_view text) {
        return settings_of(text).render.path.lobes;
    };
    EXPECT_EQ(lobes(""), LobeWidth::automatic);
    EXPECT_EQ(lobes("[render]\nlobes = \"near\"\n"), LobeWidth::near);
    EXPECT_EQ(lobes("[render]\nlobes = \"far\"\n"), LobeWidth::far);
    EXPECT_EQ(lobes("[render]\nlobes = \"auto\"\n"), LobeWidth::automatic);
    EXPECT_EQ(error_of("[render]\nlobes = \"wide\"\n"),
              "g.toml:2: unknown lobes 'wide'; one of: near, far, auto");
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
                    StartsWith("g.toml:2: 'shutter' must be [opens, closes]"));
    }
    EXPECT_NE(error_of("[render]\nmotion_samples = 1\n"), "");
}

}  // namespace
}  // namespace lancret
