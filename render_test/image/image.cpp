#include "render_test/image/image.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "guides/base/atomic_file.h"
#include "guides/base/errors.h"
#include "render_test/image/exr.h"

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

Image::Image(int w, int h)
    : width(w),
      height(h),
      rgba(std::size_t(w) * h, Eigen::Vector4f::Zero()),
      depth(rgba.size(), 0),
      normal(rgba.size(), Vec3f::Zero()),
      tangent(rgba.size(), Vec3f::Zero()),
      id(rgba.size(), kNothingId) {}

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

bool draw_text(Image& image, int x, int y, const std::string& text, int size,
               const Vec3f& colour) {
    if (text.empty()) return true;
    const float ink[] = {colour.x(), colour.y(), colour.z(), 1};
    // The library's default first, then fonts that most systems have.
    for (const char* font : {"", "DejaVuSans", "LiberationSans-Regular", "FreeSans"}) {
        const OIIO::ROI box = OIIO::ImageBufAlgo::text_size(text, size, font);
        if (!box.defined()) continue;
        // On a page with a margin around the letters: the library fails if they leave it.
        const int left = x + box.xbegin - size, top = y + box.ybegin - size;
        const OIIO::ImageSpec spec(box.width() + 2 * size, box.height() + 2 * size, 4,
                                   OIIO::TypeDesc::FLOAT);
        std::vector<Eigen::Vector4f> page(std::size_t(spec.width) * spec.height,
                                          Eigen::Vector4f::Zero());
        const auto each_shared_pixel = [&](const auto& visit) {
            for (int v = std::max(top, 0); v < std::min(top + spec.height, image.height);
                 ++v) {
                for (int u = std::max(left, 0);
                     u < std::min(left + spec.width, image.width); ++u) {
                    visit(page[std::size_t(v - top) * spec.width + (u - left)],
                          image.rgba[std::size_t(v) * image.width + u]);
                }
            }
        };
        each_shared_pixel([](auto& on_page, auto& pixel) { on_page = pixel; });
        OIIO::ImageBuf pixels(spec, page.data());
        if (OIIO::ImageBufAlgo::render_text(pixels, x - left, y - top, text, size, font,
                                            ink)) {
            each_shared_pixel([](auto& on_page, auto& pixel) { pixel = on_page; });
            return true;
        }
        pixels.geterror();  // clears the error, so that it is not reported later
    }
    return false;
}

Image reduced(const Image& image, int width, int height) {
    const OIIO::ImageBuf from(
        OIIO::ImageSpec(image.width, image.height, 4, OIIO::TypeDesc::FLOAT),
        const_cast<Eigen::Vector4f*>(image.rgba.data()));
    Image out;
    out.width = width;
    out.height = height;
    out.rgba.resize(std::size_t(width) * height);
    OIIO::ImageBuf to(OIIO::ImageSpec(width, height, 4, OIIO::TypeDesc::FLOAT),
                      out.rgba.data());
    if (!OIIO::ImageBufAlgo::resize(to, from, "box")) {
        throw std::runtime_error("a picture cannot be reduced: " + to.geterror());
    }
    return out;
}

float srgb_of_linear(float linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 1;
    return linear <= 0.0031308f ? 12.92f * linear
                                : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float linear_of_srgb(float code) {
    if (!(code > 0)) return 0;
    return code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f);
}

}  // namespace lancret
