#include "bench/render_test/sphere_scene.h"

#include <cmath>
#include <stdexcept>

#include "render_test/sampling/sampler.h"
#include "render_test/sampling/sampling.h"

namespace lancret::bench {
namespace {

constexpr float kSphere = 9, kLength = 7, kTurns = 2, kCurl = 0.35f;
constexpr int kPixels = 512;

struct Size {
    std::uint32_t strands, points;
    float pixels;  ///< width
};

Size size_of(const std::string& name) {
    if (name == "A") return {10'000, 33, 0.3f};
    if (name == "B") return {100'000, 17, 0.1f};
    throw std::invalid_argument("unknown scene, expected A or B");
}

/// A strand's axis at s in [0, 1]: out of the sphere, bent down, curled.
Vec3f place(const Vec3f& normal, float phase, float length, float s) {
    const Vec3f side = normal.unitOrthogonal(), other = normal.cross(side);
    Vec3f p = normal * (kSphere + length * (s - 0.45f * s * s));
    p.y() -= 0.5f * length * s * s;
    const float angle = phase + 2 * kPif * kTurns * s,
                wide = kCurl * std::min(1.0f, 4 * s);
    p += wide * (side * std::cos(angle) + other * std::sin(angle));
    const float min_distance = kSphere + 0.3f * std::min(1.0f, 4 * s);
    return p.norm() < min_distance ? Vec3f(p * (min_distance / p.norm())) : p;
}

Curves curly_strands(const Size& size, float radius) {
    Curves curves;
    const std::uint32_t segments = size.points - 1, points = size.points + 2;
    curves.add_class(size.strands, segments);
    curves.points = Buffer<Point4f>(curves.point_count());
    curves.segments = Buffer<std::uint32_t>(curves.segment_count());
    const float golden = kPif * (3 - std::sqrt(5.0f));
    std::size_t point = 0, segment = 0;
    for (std::uint32_t i = 0; i < size.strands; ++i) {
        const float y = 1 - 2 * (float(i) + 0.5f) / float(size.strands);
        const float r = std::sqrt(1 - y * y);
        // The angle of the golden spiral, reduced in double precision.
        const float turn = float(std::fmod(double(golden) * i, 2 * M_PI));
        const Vec3f normal(r * std::cos(turn), y, r * std::sin(turn));
        const float phase = 2 * kPif * unit_float(std::uint32_t(mix(i, 1)));
        const float length =
            kLength * (0.7f + 0.3f * unit_float(std::uint32_t(mix(i, 2))));
        for (std::uint32_t j = 0; j < segments; ++j) {
            curves.segments[segment++] = i * points + j;
        }
        for (std::uint32_t j = 0; j < points; ++j) {
            const float s = (float(j) - 1) / float(segments);
            const Vec3f p = place(normal, phase, length, s);
            curves.points[point++] = {p.x(), p.y(), p.z(), radius};
        }
    }
    return curves;
}

TriangleMesh sphere(int around, int down) {
    TriangleMesh mesh;
    for (int y = 0; y <= down; ++y) {
        for (int x = 0; x <= around; ++x) {
            const float a = 2 * kPif * float(x) / float(around),
                        b = kPif * float(y) / float(down);
            mesh.positions.push_back(kSphere * Vec3f(std::sin(b) * std::cos(a),
                                                     std::cos(b),
                                                     std::sin(b) * std::sin(a)));
        }
    }
    for (int y = 0; y < down; ++y) {
        for (int x = 0; x < around; ++x) {
            const auto a = std::uint32_t(y * (around + 1) + x);
            const std::uint32_t b = a + std::uint32_t(around) + 1;
            mesh.triangles.push_back({a, a + 1, b + 1});
            mesh.triangles.push_back({a, b + 1, b});
        }
    }
    return mesh;
}

}  // namespace

SphereScene sphere_scene(const std::string& name) {
    const Size size = size_of(name);
    SphereScene out;
    // The ball of hair, of radius at most 15 cm, fills the picture's height.
    constexpr float kAcross = 2 * 15.0f;
    out.camera = look_at(Vec3f(0, 0, 80), Vec3f(0, -1, 0), Vec3f::UnitY(),
                         2 * std::atan(kAcross / 2 / 80), 1);
    out.curves = curly_strands(size, 0.5f * size.pixels * kAcross / kPixels);
    out.mesh = sphere(96, 48);
    out.scene.lights =
        Lights(Environment(sky_map(Vec3f(0.3f, 0.45f, 0.8f), Vec3f(0.7f, 0.75f, 0.8f),
                                   Vec3f(0.2f, 0.18f, 0.15f))),
               {{Vec3f(-0.5f, 0.7f, 0.6f), Vec3f(3, 2.9f, 2.6f), 0.0047f}});
    return out;
}

}  // namespace lancret::bench
