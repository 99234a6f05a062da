#include "render_test/image/image.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <limits>

#include "guides/base/errors.h"
#include "render_test/files/read_image.h"
#include "render_test/files/write_image.h"

namespace lancret {
namespace {

namespace fs = std::filesystem;

fs::path fresh_folder(const char* name) {
    const fs::path folder = fs::path(testing::TempDir()) / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

Image tiny_image() {
    Image image(5, 3);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        const float x = float(i);
        image.rgba[i] << x / 16, x / 32, 1 - x / 16, 0.5f;
        image.depth[i] = 10 + x / 3;
        image.normal[i] = Vec3f(x / 16, -x / 16, 1);
        image.tangent[i] = Vec3f(1, x / 8, -1);
        image.id[i] = 4000000000u - std::uint32_t(i);
    }
    return image;
}

TEST(Image, PngComesBackWithinHalfAStepOfItsCode) {
    const fs::path path = fresh_folder("lancret_png") / "a.png";
    const Image image = tiny_image();
    const Vec3f background(0.1f, 0.2f, 0.3f);
    write_image(path, image, background);
    const Texture map = read_texture(path);
    ASSERT_EQ(map.width, 5);
    ASSERT_EQ(map.height, 3);
    for (std::size_t i = 0; i < 15; ++i) {
        for (int c = 0; c < 3; ++c) {
            const float over = image.rgba[i][c] + 0.5f * background[c];
            EXPECT_NEAR(srgb_of_linear(map.texels[i][c]), srgb_of_linear(over),
                        0.5f / 255 + 1e-5f);
        }
    }
}

TEST(Image, PngWithAlphaIsNotPremultiplied) {
    const fs::path path = fresh_folder("lancret_alpha") / "a.png";
    Image image(2, 1);
    image.rgba[0] << 0.2f, 0.1f, 0.05f, 0.5f;
    write_image(path, image);
    const Texture map = read_texture(path);
    // A step of the sRGB code at 0.4 linear is 0.006.
    EXPECT_LT((map.texels[0] - Vec3f(0.4f, 0.2f, 0.1f)).cwiseAbs().maxCoeff(), 0.004f);
}

TEST(Image, FloatPicturesAreReadUnchanged) {
    const fs::path path = fresh_folder("lancret_float") / "a.exr";
    const Image image = tiny_image();
    write_image(path, image);
    const Texture map = read_texture(path);
    for (std::size_t i = 0; i < 15; ++i) {
        EXPECT_EQ(map.texels[i], Vec3f(image.rgba[i].head<3>()));
    }
}

TEST(Image, NothingIsLeftBesideTheFile) {
    const fs::path folder = fresh_folder("lancret_beside");
    write_image(folder / "a.exr", tiny_image());
    write_image(folder / "a.png", tiny_image());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2);
    EXPECT_THROW(write_image(folder / "none" / "a.exr", tiny_image()), InputError);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2);
}

std::string message(const std::function<void()>& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Image, OtherExtensionsAreRefusedWithThoseAllowed) {
    EXPECT_EQ(message([] { write_image("a.jpg", tiny_image()); }),
              "a.jpg: cannot write pictures of extension '.jpg', expected .exr or .png");
}

TEST(Image, AMissingTextureIsNamed) {
    EXPECT_EQ(message([] { read_texture("/no/such/sky.exr"); }),
              "/no/such/sky.exr: no such picture");
}

TEST(Image, FilesOtherThanPicturesAreRefused) {
    const fs::path folder = fresh_folder("lancret_broken");
    const fs::path text = folder / "a.png";
    std::ofstream(text) << "this is not a picture";
    EXPECT_THROW(read_texture(text), InputError);
    // A truncated image.
    const fs::path whole = folder / "b.exr", cut = folder / "c.exr";
    write_image(whole, tiny_image());
    fs::copy_file(whole, cut);
    fs::resize_file(cut, fs::file_size(whole) / 2);
    EXPECT_THROW(read_texture(cut), InputError);
}

TEST(Image, NanInATextureIsRefusedWithItsPlace) {
    const fs::path path = fresh_folder("lancret_nan") / "a.exr";
    Image image = tiny_image();
    image.rgba[7].x() = std::numeric_limits<float>::quiet_NaN();
    write_image(path, image);
    EXPECT_EQ(message([&] { read_texture(path); }),
              path.string() + ": texel 2, 1 is not a finite number");
}

}  // namespace
}  // namespace lancret
