#include "render_test/image/draw.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace lancret {

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

}  // namespace lancret
