#include "render_test/lights.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render_test/sampling.h"

namespace lancret {

bool Lights::Disc::holds(const Vec3f& direction) const {
    // By the cross product: one minus a cosine has no digits for a disc like the sun.
    const Vec3f axis = frame.col(2);
    return axis.dot(direction) > 0 && axis.cross(direction).squaredNorm() <= sine2;
}

Lights::Lights(Environment environment, const std::vector<DistantLight>& distant)
    : environment_(std::move(environment)) {
    // Shares by what a surface that faces each light receives; less for an even
    // environment, which scattering finds as well.
    environment_share_ =
        kPi * environment_.mean_luminance() * std::max(0.05f, environment_.unevenness());
    float total = environment_share_;
    for (const DistantLight& light : distant) {
        if (!(light.angular_radius >= 0.0005f && light.angular_radius <= 1.5f))
            throw std::invalid_argument(
                "a distant light's angular radius must be within 0.0005 and 1.5 radian");
        if (!light.direction.allFinite() || !(light.direction.norm() > 0))
            throw std::invalid_argument("a distant light needs a direction");
        if (!light.irradiance.allFinite() || light.irradiance.minCoeff() < 0)
            throw std::invalid_argument(
                "a distant light's irradiance must be finite and not negative");
        const float sine = std::sin(light.angular_radius);
        const float half = std::sin(light.angular_radius / 2);
        Disc disc;
        disc.frame = frame_about(light.direction.normalized());
        disc.sine2 = sine * sine;
        disc.radiance = light.irradiance / (kPi * disc.sine2);
        disc.pdf = 1 / (4 * kPi * half * half);
        disc.share = luminance(light.irradiance);
        total += disc.share;
        discs_.push_back(disc);
    }
    if (!(total > 0)) return;
    environment_share_ /= total;
    for (Disc& disc : discs_) disc.share /= total;
}

LightSample Lights::along(const Vec3f& direction) const {
    LightSample sum = environment_.along(direction);
    sum.pdf = environment_share_ > 0 ? environment_share_ * sum.pdf : 0;
    for (const Disc& disc : discs_)
        if (disc.holds(direction)) {
            sum.radiance += disc.radiance;
            sum.pdf += disc.share * disc.pdf;
        }
    return sum;
}

Vec3f Lights::radiance(const Vec3f& direction) const { return along(direction).radiance; }

float Lights::pdf(const Vec3f& direction) const { return along(direction).pdf; }

LightSample Lights::sample(float pick, const Vec2f& random) const {
    LightSample sample;
    const Disc* chosen = nullptr;
    for (const Disc& disc : discs_) {
        chosen = pick < disc.share ? &disc : nullptr;
        if (chosen) break;
        pick -= disc.share;
    }
    if (chosen) {
        // Uniform on the cap: 1 - cos = 2 sin^2(a / 2), scaled. Pulled in by a rounding
        // so that `holds` agrees.
        const float versine = random.x() * 0.99999f / (2 * kPi * chosen->pdf);
        const float r = std::sqrt(versine * (2 - versine));
        const float phi = 2 * kPi * random.y();
        sample.direction =
            (chosen->frame * Vec3f(r * std::cos(phi), r * std::sin(phi), 1 - versine))
                .normalized();
    } else {
        if (!(environment_share_ > 0)) return sample;
        sample.direction = environment_.sample(random).direction;
    }
    return along(sample.direction);
}

Lights default_lights(const Vec3f& view, const Vec3f& up) {
    const Vec3f right = view.cross(up).norm() > 1e-4f ? Vec3f(view.cross(up).normalized())
                                                      : Vec3f(view.unitOrthogonal());
    const Vec3f above = right.cross(view);
    const Vec3f key = -view - 0.8f * right + 0.9f * above;
    const Vec3f rim = 0.9f * view + 0.7f * right + 0.8f * above;
    return Lights(Environment(sky_map(Vec3f(0.75f, 0.85f, 1.0f), Vec3f(0.6f, 0.6f, 0.6f),
                                      Vec3f(0.2f, 0.18f, 0.16f)),
                              up),
                  {{key, 4.0f * Vec3f(1, 0.97f, 0.92f), 0.3f},
                   {rim, 2.0f * Vec3f(0.95f, 0.97f, 1), 0.3f}});
}

}  // namespace lancret
