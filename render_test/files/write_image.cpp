#include "render_test/files/write_image.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <string>
#include <vector>

#include "guides/base/atomic_file.h"
#include "guides/base/errors.h"
#include "render_test/files/exr.h"

namespace lancret {
namespace {

namespace fs = std::filesystem;

std::uint8_t byte_of(float linear) {
    return std::uint8_t(srgb_of_linear(linear) * 255 + 0.5f);
}

void write_png(const std::string& path, const Image& image,
               const std::optional<Vec3f>& background) {
    const int channels = background ? 3 : 4;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.rgba.size() * channels);
    for (const Eigen::Vector4f& pixel : image.rgba) {
        const float alpha = std::clamp(pixel.w(), 0.0f, 1.0f);
        Vec3f colour = pixel.head<3>();
        if (background) {
            colour += (1 - alpha) * *background;
        } else if (alpha > 0) {
            colour /= alpha;
        }
        for (int c = 0; c < 3; ++c) bytes.push_back(byte_of(colour[c]));
        if (!background) bytes.push_back(std::uint8_t(alpha * 255 + 0.5f));
    }
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) throw std::runtime_error(OIIO::geterror());
    OIIO::ImageSpec spec(image.width, image.height, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (!output->open(path, spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) || !output->close()) {
        throw std::runtime_error(output->geterror());
    }
}

}  // namespace

void write_image(const fs::path& path, const Image& image,
                 const std::optional<Vec3f>& background) {
    const std::string extension = path.extension().string();
    if (extension != ".exr" && extension != ".png") {
        throw InputError(path.string() + ": cannot write pictures of extension '" +
                         extension + "', expected .exr or .png");
    }
    PendingFile file(path);
    try {
        if (extension == ".exr") {
            write_exr(file.temporary(), image);
        } else {
            write_png(file.temporary().string(), image, background);
        }
    } catch (const std::exception& error) {
        throw InputError(path.string() + ": cannot be written: " + error.what());
    }
    file.commit();
}

}  // namespace lancret
