#include "render_test/material/strand_section.h"

#include <algorithm>
#include <cmath>

#include "render_test/material/bsdf.h"

namespace lancret {
namespace {

/// Refracts `d` at a surface of unit normal `n` on its side; `ratio` is the index of the
/// first medium over that of the second. Returns false at total reflection.
bool refract(const Vec2f& d, const Vec2f& n, float ratio, Vec2f& out) {
    const float cosine = -d.dot(n);
    const float sine2 = square(ratio) * std::max(0.0f, 1 - square(cosine));
    if (sine2 >= 1) return false;
    out = (ratio * d + (ratio * cosine - std::sqrt(1 - sine2)) * n).normalized();
    return true;
}

Vec2f reflect(const Vec2f& d, const Vec2f& n) {
    return (d - 2 * d.dot(n) * n).normalized();
}

}  // namespace

SectionPaths section_paths(const StrandSection& section, float h, float cosine_o,
                           float bravais, float eta) {
    // In the axes of the ellipse, x being the major one. `back` is the viewer's z.
    const float c = std::cos(section.angle), s = std::sin(section.angle);
    const Vec2f across(c, -s), back(s, c);
    const Vec2f inverse2(1, 1 / square(section.aspect));
    const auto normal_at = [&](const Vec2f& p) -> Vec2f {
        return p.cwiseProduct(inverse2).normalized();
    };
    // Scaled to a circle, the ray meets the ellipse at h beside its middle: at h times
    // the conjugate direction `beside` plus sqrt(1 - h^2) times that of the ray.
    const Vec2f axes(1, section.aspect);
    const Vec2f scaled = back.cwiseQuotient(axes).normalized();
    const Vec2f beside(scaled.y(), -scaled.x());
    const float out = std::sqrt(std::max(0.0f, 1 - square(h)));
    Vec2f p = (h * beside + out * scaled).cwiseProduct(axes);
    Vec2f n = normal_at(p);

    SectionPaths paths{};
    const auto azimuth_of = [&](const Vec2f& d) {
        return std::atan2(d.dot(back), d.dot(across));
    };
    Vec2f d = -back;
    const float cosine = std::clamp(-d.dot(n), 0.0f, 1.0f);
    paths.azimuth[0] = azimuth_of(reflect(d, n));
    paths.fresnel[0] = fresnel_dielectric(cosine_o * cosine, eta);
    Vec2f inside;
    if (!refract(d, n, 1 / bravais, inside)) inside = d;
    d = inside;
    for (int k = 0; k < 2; ++k) {
        const Vec2f scaled_d = d.cwiseProduct(inverse2);
        const float length = std::max(0.0f, -2 * p.dot(scaled_d) / d.dot(scaled_d));
        paths.chord[k] = length;
        p += length * d;
        n = normal_at(p);
        Vec2f leaves;
        if (refract(d, -n, bravais, leaves)) {
            paths.azimuth[k + 1] = azimuth_of(leaves);
            const float outside = std::clamp(leaves.dot(n), 0.0f, 1.0f);
            paths.fresnel[k + 1] = fresnel_dielectric(cosine_o * outside, eta);
        } else {
            paths.azimuth[k + 1] = 0;
            paths.fresnel[k + 1] = 1;
        }
        d = reflect(d, n);
    }
    return paths;
}

}  // namespace lancret
