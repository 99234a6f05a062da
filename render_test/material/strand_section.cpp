#include "render_test/material/strand_section.h"

#include <algorithm>
#include <cmath>

#include "render_test/material/hair_bsdf.h"

namespace lancret {
namespace {

float square(float x) { return x * x; }

/// Turns from one medium to another at a surface of unit normal `n` that `d` runs
/// against; `ratio` is the index before over that behind. False where none goes through.
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
    // In the ellipse's own axes: the major one is x. The viewer's z lies at `turn`.
    const float c = std::cos(section.angle), s = std::sin(section.angle);
    const Vec2f across(c, -s), back(s, c);
    const Vec2f inverse2(1, 1 / square(section.aspect));
    const auto normal_at = [&](const Vec2f& p) -> Vec2f {
        return p.cwiseProduct(inverse2).normalized();
    };
    // The ray meets the ellipse where, scaled to a circle, it stands at h beside the
    // middle: the place is across / w h + the conjugate direction sqrt(1 - h^2).
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
