#include "guides/made/made_lawn.h"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>

#include "guides/base/cancel.h"
#include "guides/base/hash.h"
#include "guides/mesh/scalp.h"
#include "guides/mesh/scalp_roots.h"

namespace lancret {

namespace {

constexpr std::uint32_t kCells = 48;  ///< per side

/// The use of a random number.
enum class LawnSalt : std::uint64_t { length = 1, side, lean, bow, own_length };

/// The ground's height, cm: a rise in the middle and a fold across it.
double height(double x, double z) {
    const double r2 = (x * x + z * z) / (kMadeLawn * kMadeLawn);
    return 7 * std::exp(-6 * r2) + 0.8 * std::sin(0.11 * x + 0.07 * z);
}

TriangleMesh make_ground() {
    TriangleMesh mesh;
    const auto uv = [](std::uint32_t i, std::uint32_t j) {
        return Vec2f(float(i) / kCells, float(j) / kCells);
    };
    for (std::uint32_t j = 0; j <= kCells; ++j) {
        for (std::uint32_t i = 0; i <= kCells; ++i) {
            const double x = kMadeLawn * (double(i) / kCells - 0.5);
            const double z = kMadeLawn * (0.5 - double(j) / kCells);
            mesh.positions.emplace_back(float(x), float(height(x, z)), float(z));
        }
    }
    const auto add = [&](std::array<std::array<std::uint32_t, 2>, 3> corners) {
        auto& triangle = mesh.triangles.emplace_back();
        auto& uvs = mesh.uvs.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
            const auto [i, j] = corners[c];
            triangle[c] = j * (kCells + 1) + i;
            uvs[c] = uv(i, j);
        }
    };
    for (std::uint32_t j = 0; j < kCells; ++j) {
        for (std::uint32_t i = 0; i < kCells; ++i) {
            add({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
            add({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
        }
    }
    return mesh;
}

/// A blade's points from its root.
std::vector<Vec3> blade(const MadeGroomSettings& settings, std::uint64_t id,
                        const Vec3& root, const Vec3& normal) {
    const auto random = [&](LawnSalt salt) {
        return unit_double(hash_bits(settings.seed, id, std::uint64_t(salt)));
    };
    const double spread =
        1 + settings.length_spread * (2 * random(LawnSalt::own_length) - 1);
    const double length =
        spread * (settings.shortest +
                  random(LawnSalt::length) * (settings.longest - settings.shortest));
    const double ds = length / (settings.points - 1);

    const double breeze = 0.6 + 0.9 * std::sin(0.09 * root.x() + 0.05 * root.z());
    const double angle = breeze + 0.8 * (2 * kPi) * (random(LawnSalt::side) - 0.5);
    Vec3 side(std::cos(angle), 0, std::sin(angle));
    side = (side - normal * normal.dot(side)).normalized();
    const double lean = 0.08 + 0.3 * random(LawnSalt::lean),
                 bow = 0.25 + 1.3 * random(LawnSalt::bow);

    std::vector<Vec3> points{root};
    for (int i = 1; i < settings.points; ++i) {
        const double s = (i - 0.5) / (settings.points - 1);
        const double bent = lean + bow * std::pow(s, 1.5);
        points.push_back(points.back() +
                         ds * (std::cos(bent) * normal + std::sin(bent) * side));
    }
    return points;
}

}  // namespace

MadeGroom make_lawn(const MadeGroomSettings& settings) {
    check_made(settings);
    MadeGroom lawn;
    lawn.head = make_ground();
    lawn.scalp = lawn.head;
    const Scalp ground = make_scalp(lawn.scalp);
    const auto count = std::size_t(settings.strands),
               points = std::size_t(settings.points);
    const auto roots = scalp_roots(ground, count, settings.seed);

    Strands& strands = lawn.strands;
    strands.default_thickness = 0.3f;
    strands.default_colour = {0.1f, 0.25f, 0.05f};
    strands.points.resize(count * points);
    for (std::size_t i = 1; i <= count; ++i) {
        strands.first.push_back(std::uint32_t(i * points));
    }
    cancellable_for(std::size_t(0), count, [&](std::size_t i) {
        const std::vector<Vec3> made =
            blade(settings, i, scalp_position(ground, roots[i]),
                  scalp_normal(ground, roots[i]));
        for (std::size_t j = 0; j < points; ++j) {
            strands.points[i * points + j] = made[j].cast<float>();
        }
    });
    return lawn;
}

}  // namespace lancret
