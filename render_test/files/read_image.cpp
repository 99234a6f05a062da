#include "render_test/files/read_image.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "guides/base/errors.h"
#include "render_test/image/image.h"

namespace lancret {

namespace fs = std::filesystem;

Texture read_texture(const fs::path& path) {
    const auto fail = [&](const std::string& why) {
        return InputError(path.string() + ": " + why);
    };
    if (!fs::exists(path)) throw fail("no such picture");
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path.string(), &as_stored);
    if (!input) throw fail("not a picture that can be read: " + OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    constexpr std::int64_t kMaxTexels = std::int64_t(1) << 27;
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 ||
        std::int64_t(spec.width) * spec.height > kMaxTexels) {
        throw fail("a picture of " + std::to_string(spec.width) + " x " +
                   std::to_string(spec.height) + " x " + std::to_string(spec.depth) +
                   " with " + std::to_string(spec.nchannels) +
                   " channels, expected a flat one of at most 2^27 texels");
    }
    const int channels = spec.nchannels < 3 ? 1 : 3;
    const bool coded =
        spec.format == OIIO::TypeDesc::UINT8 || spec.format == OIIO::TypeDesc::UINT16;
    Texture map{spec.width, spec.height, {}};
    const std::size_t size = std::size_t(map.width) * map.height;
    std::vector<float> values(size * channels);
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data())) {
        throw fail("broken picture: " + input->geterror());
    }
    map.texels.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
        for (int c = 0; c < 3; ++c) {
            const float value = values[i * channels + std::min(c, channels - 1)];
            if (!std::isfinite(value)) {
                throw fail("texel " + std::to_string(i % map.width) + ", " +
                           std::to_string(i / map.width) + " is not a finite number");
            }
            map.texels[i][c] = coded ? linear_of_srgb(value) : std::max(value, 0.0f);
        }
    }
    return map;
}

}  // namespace lancret
