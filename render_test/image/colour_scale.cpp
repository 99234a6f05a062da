#include "render_test/image/colour_scale.h"

#include <algorithm>
#include <cmath>

namespace lancret {

namespace {

/// As oklab_colour, without clamping.
Vec3f unclamped_oklab(float lightness, float chroma, float hue) {
    const float angle = hue * kPif / 180;
    const float a = chroma * std::cos(angle), b = chroma * std::sin(angle);
    const auto cube = [](float x) { return x * x * x; };
    const float l = cube(lightness + 0.3963377774f * a + 0.2158037573f * b);
    const float m = cube(lightness - 0.1055613458f * a - 0.0638541728f * b);
    const float s = cube(lightness - 0.0894841775f * a - 1.2914855480f * b);
    return {4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s,
            -1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s,
            -0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s};
}

/// The largest chroma of a lightness and hue within the gamut, at most `limit`.
float chroma_within(float lightness, float limit, float hue) {
    float low = 0, high = limit;
    for (int i = 0; i < 16; ++i) {
        const float middle = (low + high) / 2;
        const Vec3f colour = unclamped_oklab(lightness, middle, hue);
        (colour.minCoeff() < 0 || colour.maxCoeff() > 1 ? high : low) = middle;
    }
    return low;
}

}  // namespace

Vec3f oklab_colour(float lightness, float chroma, float hue) {
    return unclamped_oklab(lightness, chroma, hue).cwiseMax(0.0f).cwiseMin(1.0f);
}

Vec3f sequential_colour(float t) {
    t = std::clamp(t, 0.0f, 1.0f);
    // Near the gamut's limit of chroma, which is lowest in the middle, at blue-green.
    const float away = 2 * t - 1;
    return oklab_colour(0.38f + 0.54f * t, 0.1f + 0.08f * away * away, 300 - 190 * t);
}

Vec3f diverging_colour(float t) {
    t = std::clamp(t, -1.0f, 1.0f);
    const float size = std::abs(t);
    return oklab_colour(0.88f - 0.33f * size, 0.14f * size, t < 0 ? 260.0f : 50.0f);
}

Vec3f category_colour(std::uint32_t category) {
    constexpr double kGolden = 0.6180339887498949;
    constexpr float kLightness[] = {0.7f, 0.58f, 0.8f};
    const double turns = 0.08 + kGolden * category;
    const float lightness = kLightness[category % 3];
    const float hue = float(360 * (turns - std::floor(turns)));
    return oklab_colour(lightness, chroma_within(lightness, 0.17f, hue), hue);
}

float scale_place(const ColourScale& scale, float value) {
    const auto place = [](double x, double low, double high) {
        return float(std::clamp((x - low) / (high - low), 0.0, 1.0));
    };
    if (scale.kind != ColourScale::Kind::logarithmic) {
        return place(value, scale.low, scale.high);
    }
    return value > 0 ? place(std::log(value), std::log(scale.low), std::log(scale.high))
                     : 0;
}

Vec3f scale_colour_at(const ColourScale& scale, float place) {
    return scale.kind == ColourScale::Kind::diverging ? diverging_colour(2 * place - 1)
                                                      : sequential_colour(place);
}

Vec3f scale_colour(const ColourScale& scale, float value) {
    if (!scale.over.empty() && value > scale.high) return kFailColour;
    if (scale.clean && value <= *scale.clean) return kCleanColour;
    return scale_colour_at(scale, scale_place(scale, value));
}

}  // namespace lancret
