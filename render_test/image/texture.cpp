#include "render_test/image/texture.h"

#include <cmath>

namespace lancret {

Vec3f texture_colour(const Texture& map, const Vec2f& uv) {
    struct Pair {
        int low, high;
        float share;  ///< of the higher
    };
    const auto texels = [](float t, int size) -> Pair {
        const float x = (t - std::floor(t)) * float(size) - 0.5f;
        const int low = int(std::floor(x));
        return {(low + size) % size, (low + 1) % size, x - float(low)};
    };
    const Pair x = texels(uv.x(), map.width), y = texels(1 - uv.y(), map.height);
    const auto row = [&](int at) -> Vec3f {
        return (1 - x.share) * map.at(x.low, at) + x.share * map.at(x.high, at);
    };
    return (1 - y.share) * row(y.low) + y.share * row(y.high);
}

}  // namespace lancret
