#include "render_test/image.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <half.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "guides/errors.h"

namespace lancret {
namespace {

namespace fs = std::filesystem;

/// Values of half precision stay finite: the largest half is 65504.
half half_of(float x) { return half(std::clamp(x, -65504.0f, 65504.0f)); }

void write_exr(const std::string& path, const Image& image) {
    // Halves interleaved by layer: R G B A, N, T.
    const std::size_t pixels = image.rgba.size();
    constexpr std::size_t kHalves = 10;
    std::vector<half> halves(pixels * kHalves);
    for (std::size_t i = 0; i < pixels; ++i) {
        half* out = &halves[i * kHalves];
        for (int c = 0; c < 4; ++c) out[c] = half_of(image.rgba[i][c]);
        for (int c = 0; c < 3; ++c) out[4 + c] = half_of(image.normal[i][c]);
        for (int c = 0; c < 3; ++c) out[7 + c] = half_of(image.tangent[i][c]);
    }
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    const auto add = [&](const char* name, Imf::PixelType type, const void* data,
                         std::size_t stride) {
        header.channels().insert(name, Imf::Channel(type));
        char* base = const_cast<char*>(static_cast<const char*>(data));
        frame.insert(name, Imf::Slice(type, base, stride, stride * image.width));
    };
    const char* const names[kHalves] = {"R",   "G",   "B",   "A",   "N.X",
                                        "N.Y", "N.Z", "T.X", "T.Y", "T.Z"};
    for (std::size_t c = 0; c < kHalves; ++c)
        add(names[c], Imf::HALF, halves.data() + c, kHalves * sizeof(half));
    add("Z", Imf::FLOAT, image.depth.data(), sizeof(float));
    add("id", Imf::UINT, image.id.data(), sizeof(std::uint32_t));
    if (!image.value.empty()) add("value", Imf::FLOAT, image.value.data(), sizeof(float));
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(image.height);
}

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
        if (background)
            colour += (1 - alpha) * *background;
        else if (alpha > 0)
            colour /= alpha;
        for (int c = 0; c < 3; ++c) bytes.push_back(byte_of(colour[c]));
        if (!background) bytes.push_back(std::uint8_t(alpha * 255 + 0.5f));
    }
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) throw std::runtime_error(OIIO::geterror());
    OIIO::ImageSpec spec(image.width, image.height, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (!output->open(path, spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) || !output->close())
        throw std::runtime_error(output->geterror());
}

/// The file that is written before it takes the place of `path`; same folder, same
/// extension.
fs::path beside(const fs::path& path) {
    fs::path name = path.stem();
    name += ".part" + std::to_string(getpid());
    name += path.extension();
    return path.parent_path() / name;
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
    if (extension != ".exr" && extension != ".png")
        throw InputError(path.string() + ": cannot write pictures of extension '" +
                         extension + "', expected .exr or .png");
    const fs::path part = beside(path);
    try {
        if (extension == ".exr")
            write_exr(part.string(), image);
        else
            write_png(part.string(), image, background);
        fs::rename(part, path);
    } catch (const std::exception& error) {
        std::error_code ignored;
        fs::remove(part, ignored);
        throw InputError(path.string() + ": cannot be written: " + error.what());
    }
}

ColourMap read_colour_map(const fs::path& path) {
    const auto fail = [&](const std::string& why) {
        return InputError(path.string() + ": " + why);
    };
    if (!fs::exists(path)) throw fail("no such picture");
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path.string(), &as_stored);
    if (!input) throw fail("not a picture that can be read: " + OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    constexpr std::int64_t kMostTexels = std::int64_t(1) << 27;
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 ||
        std::int64_t(spec.width) * spec.height > kMostTexels)
        throw fail("a picture of " + std::to_string(spec.width) + " x " +
                   std::to_string(spec.height) + " x " + std::to_string(spec.depth) +
                   " with " + std::to_string(spec.nchannels) +
                   " channels, expected a flat one of at most 2^27 texels");
    const int channels = spec.nchannels < 3 ? 1 : 3;
    const bool coded =
        spec.format == OIIO::TypeDesc::UINT8 || spec.format == OIIO::TypeDesc::UINT16;
    ColourMap map{spec.width, spec.height, {}};
    const std::size_t size = std::size_t(map.width) * map.height;
    std::vector<float> values(size * channels);
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data()))
        throw fail("broken picture: " + input->geterror());
    map.texels.resize(size);
    for (std::size_t i = 0; i < size; ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = values[i * channels + std::min(c, channels - 1)];
            if (!std::isfinite(value))
                throw fail("texel " + std::to_string(i % map.width) + ", " +
                           std::to_string(i / map.width) + " is not a finite number");
            map.texels[i][c] = coded ? linear_of_srgb(value) : std::max(value, 0.0f);
        }
    return map;
}

bool draw_text(Image& image, int x, int y, const std::string& text, int size,
               const Vec3f& colour) {
    if (text.empty()) return true;
    const float ink[] = {colour.x(), colour.y(), colour.z(), 1};
    // The library's own choice first, then what most systems have.
    for (const char* font : {"", "DejaVuSans", "LiberationSans-Regular", "FreeSans"}) {
        const OIIO::ROI box = OIIO::ImageBufAlgo::text_size(text, size, font);
        if (!box.defined()) continue;
        // On a page with room about the letters: the library fails where they leave it.
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
        pixels.geterror();  // taken, so that it is not told later
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
    if (!OIIO::ImageBufAlgo::resize(to, from, "box"))
        throw std::runtime_error("a picture cannot be reduced: " + to.geterror());
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
