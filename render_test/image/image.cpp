#include "render_test/image/image.h"

#include <cmath>

namespace lancret {

Image::Image(int w, int h)
    : width(w),
      height(h),
      rgba(std::size_t(w) * h, Eigen::Vector4f::Zero()),
      depth(rgba.size(), 0),
      normal(rgba.size(), Vec3f::Zero()),
      tangent(rgba.size(), Vec3f::Zero()),
      id(rgba.size(), kNothingId) {}

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
