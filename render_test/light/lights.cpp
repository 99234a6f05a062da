#include "render_test/light/lights.h"

#include <algorithm>
#include <cmath>

#include "guides/base/errors.h"
#include "render_test/sampling/sampling.h"

namespace lancret {
namespace {

using Disc = Lights::Disc;
using Rectangle = Lights::Rectangle;

bool is_light(const Vec3f& colour) {
    return colour.allFinite() && colour.minCoeff() >= 0;
}

bool is_direction(const Vec3f& v) { return v.allFinite() && v.norm() > 0; }

Disc disc_of(const DistantLight& light) {
    require(light.angular_radius >= 0.0005f && light.angular_radius <= 1.5f,
            "a distant light's angular radius must be within 0.0005 and 1.5 radian");
    require(is_direction(light.direction), "a distant light needs a direction");
    require(is_light(light.irradiance),
            "a distant light's irradiance must be finite and not negative");
    const float sine = std::sin(light.angular_radius);
    const float half = std::sin(light.angular_radius / 2);
    Disc disc;
    disc.frame = frame_about(light.direction.normalized());
    disc.sine2 = sine * sine;
    disc.radiance = light.irradiance / (kPif * disc.sine2);
    disc.pdf = 1 / (4 * kPif * half * half);
    return disc;
}

Rectangle rectangle_of(const RectangleLight& light) {
    require(
        light.centre.allFinite() && is_direction(light.normal) && is_direction(light.up),
        "a rectangle of light needs a centre, a normal and an up direction");
    require(light.size.allFinite() && light.size.minCoeff() > 0,
            "a rectangle of light needs a width and a height above 0");
    require(is_light(light.radiance),
            "a rectangle's radiance must be finite and not negative");
    Rectangle out;
    out.centre = light.centre;
    out.half = light.size / 2;
    out.radiance = light.radiance;
    const Vec3f normal = light.normal.normalized();
    const Vec3f across = light.up.normalized().cross(normal);
    if (across.norm() > 1e-5f) {
        const Vec3f width = across.normalized();
        out.frame << width, normal.cross(width), normal;
    } else {
        out.frame = frame_about(normal);
    }
    return out;
}

/// One minus the cosine of the cone that a sphere subtends from outside.
float cone_versine(float sine2) {
    return sine2 / (1 + std::sqrt(std::max(0.0f, 1 - sine2)));
}

/// A direction about the third column of `frame`, uniform on the cap of that versine.
Vec3f cap_direction(const Mat3f& frame, float versine, const Vec2f& random) {
    const float v = random.x() * versine;
    const float r = std::sqrt(std::max(0.0f, v * (2 - v))), phi = 2 * kPif * random.y();
    return (frame * Vec3f(r * std::cos(phi), r * std::sin(phi), 1 - v)).normalized();
}

// Per shape: a sample towards it (`sample_of`), and its light along a direction (`met`).
LightSample sample_of(const Environment& environment, const Vec3f&, const Vec2f& random) {
    return environment.sample(random);
}

LightSample sample_of(const Disc& disc, const Vec3f&, const Vec2f& random) {
    // Reduced by a rounding, so that `met` agrees.
    const float versine = 0.99999f / (2 * kPif * disc.pdf);
    return {cap_direction(disc.frame, versine, random), disc.radiance, disc.pdf};
}

LightSample sample_of(const Rectangle& r, const Vec3f& from, const Vec2f& random) {
    const Vec2f place = (2 * random - Vec2f::Ones()).cwiseProduct(r.half);
    const Vec3f towards = r.centre + r.frame.leftCols<2>() * place - from;
    LightSample sample;
    sample.distance = towards.norm();
    sample.radiance = r.radiance;
    if (!(sample.distance > 0)) return sample;
    sample.direction = towards / sample.distance;
    const float cosine = -sample.direction.dot(r.frame.col(2));
    if (cosine > 1e-6f) {
        sample.pdf = sample.distance * sample.distance / (4 * r.half.prod() * cosine);
    }
    return sample;
}

LightSample sample_of(const SphereLight& s, const Vec3f& from, const Vec2f& random) {
    const Vec3f towards = s.centre - from;
    const float d2 = towards.squaredNorm(), r2 = s.radius * s.radius;
    LightSample sample;
    sample.radiance = s.radiance;
    if (d2 > r2) {
        const float versine = cone_versine(r2 / d2);
        sample.direction =
            cap_direction(frame_about(towards / std::sqrt(d2)), versine, random);
        sample.pdf = 1 / (2 * kPif * versine);
    } else {
        sample.direction = uniform_sphere(random);
        sample.pdf = 1 / (4 * kPif);
    }
    const float along = towards.dot(sample.direction);
    const float across2 = (towards - along * sample.direction).squaredNorm();
    const float half = std::sqrt(std::max(0.0f, r2 - across2));
    sample.distance = d2 > r2 ? std::max(along - half, 0.0f) : along + half;
    return sample;
}

LightSample met(const Environment& environment, const Vec3f&, const Vec3f& direction) {
    return environment.along(direction);
}

LightSample met(const Disc& disc, const Vec3f&, const Vec3f& direction) {
    // By the cross product: one minus a cosine loses all digits for a disc like the sun.
    const Vec3f axis = disc.frame.col(2);
    if (axis.dot(direction) <= 0 || axis.cross(direction).squaredNorm() > disc.sine2) {
        return {};
    }
    return {direction, disc.radiance, disc.pdf};
}

LightSample met(const Rectangle& r, const Vec3f& from, const Vec3f& direction) {
    const float cosine = -direction.dot(r.frame.col(2));
    const Vec3f offset = from - r.centre;
    if (cosine <= 1e-6f) return {};
    const float distance = offset.dot(r.frame.col(2)) / cosine;
    if (!(distance > 0)) return {};
    const Vec2f place =
        r.frame.leftCols<2>().transpose() * (offset + distance * direction);
    if ((place.cwiseAbs() - r.half).maxCoeff() > 0) return {};
    return {direction, r.radiance, distance * distance / (4 * r.half.prod() * cosine),
            distance};
}

LightSample met(const SphereLight& s, const Vec3f& from, const Vec3f& direction) {
    const Vec3f towards = s.centre - from;
    const float d2 = towards.squaredNorm(), r2 = s.radius * s.radius;
    const float along = towards.dot(direction);
    const float across2 = (towards - along * direction).squaredNorm();
    if (d2 > r2 && (along <= 0 || across2 > r2)) return {};
    const float half = std::sqrt(std::max(0.0f, r2 - across2));
    if (d2 > r2) {
        return {direction, s.radiance, 1 / (2 * kPif * cone_versine(r2 / d2)),
                std::max(along - half, 0.0f)};
    }
    return {direction, s.radiance, 1 / (4 * kPif), along + half};
}

}  // namespace

Lights::Lights(Environment environment, const std::vector<DistantLight>& distant,
               const std::vector<RectangleLight>& rectangles,
               const std::vector<SphereLight>& spheres) {
    shapes_.emplace_back(std::move(environment));
    for (const DistantLight& light : distant) shapes_.emplace_back(disc_of(light));
    for (const RectangleLight& light : rectangles) {
        shapes_.emplace_back(rectangle_of(light));
    }
    for (const SphereLight& light : spheres) {
        require(
            light.centre.allFinite() && std::isfinite(light.radius) && light.radius > 0,
            "a sphere of light needs a centre and a radius above 0");
        require(is_light(light.radiance),
                "a sphere's radiance must be finite and not negative");
        shapes_.emplace_back(light);
    }
}

const Environment& Lights::environment() const {
    return std::get<Environment>(shapes_.front());
}

LightSample Lights::meet(const Shape& shape, const Vec3f& from, const Vec3f& direction) {
    return std::visit([&](const auto& s) { return met(s, from, direction); }, shape);
}

LightSample Lights::sample(std::size_t light, const Vec3f& from,
                           const Vec2f& random) const {
    return std::visit([&](const auto& shape) { return sample_of(shape, from, random); },
                      shapes_[light]);
}

Vec3f Lights::radiance(const Vec3f& from, const Vec3f& direction) const {
    return along(from, direction, std::numeric_limits<float>::infinity(),
                 [](float) { return 1.0f; });
}

Lights default_lights(const Vec3f& view, const Vec3f& up) {
    const Vec3f right = view.cross(up).norm() > 1e-4f ? Vec3f(view.cross(up).normalized())
                                                      : Vec3f(view.unitOrthogonal());
    const Vec3f above = right.cross(view);
    const Vec3f key = -view - 0.8f * right + 0.9f * above;
    const Vec3f fill = -view + 1.1f * right + 0.1f * above;
    const Vec3f rim = 0.9f * view + 0.7f * right + 0.8f * above;
    return Lights(Environment(sky_map(Vec3f(0.75f, 0.85f, 1.0f), Vec3f(0.6f, 0.6f, 0.6f),
                                      Vec3f(0.2f, 0.18f, 0.16f)),
                              up),
                  {{key, 4.0f * Vec3f(1, 0.97f, 0.92f), 0.3f},
                   {fill, 0.8f * Vec3f(0.95f, 0.97f, 1), 0.8f},
                   {rim, 2.0f * Vec3f(0.95f, 0.97f, 1), 0.3f}});
}

}  // namespace lancret
