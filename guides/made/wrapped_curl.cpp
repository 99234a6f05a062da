#include "guides/made/wrapped_curl.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "guides/base/hash.h"
#include "guides/strand/curve.h"
#include "guides/strand/rotation_minimizing.h"

namespace lancret {

namespace {

/// Share of a strand over which its curl grows in.
constexpr double kGrowth = 0.2;

/// Points per turn: a spline through them deviates from a circle by (2 pi / 24)^4 / 384 =
/// 1.2e-5 of its radius.
constexpr double kPointsPerTurn = 24;
constexpr int kMinPoints = 64;

/// Maximum deviation of a strand's turns, in standard deviations.
constexpr double kMaxDeviations = 3;

/// The random values of a strand.
struct DrawnCurl {
    double turns, phase;
};

DrawnCurl drawn_curl(const CurlSettings& curl, std::uint64_t seed, std::size_t strand) {
    constexpr std::uint64_t kSalt = 0x6375726c;  // "curl"
    const auto draw = [&](std::uint64_t n) {
        return unit_double(hash_bits(seed, strand, kSalt + n));
    };
    // A normal number by Box and Muller.
    const double normal =
        std::sqrt(-2 * std::log(1 - draw(0))) * std::cos((2 * kPi) * draw(1));
    const double within = std::clamp(normal, -kMaxDeviations, kMaxDeviations);
    return {std::max(0.0, curl.turns * (1 + curl.jitter * within)), (2 * kPi) * draw(2)};
}

}  // namespace

Strands wrapped_in_curls(const Strands& strands, const CurlSettings& curl,
                         std::uint64_t seed) {
    const auto within = [](double value, double limit) {
        return value >= 0 && value <= limit;
    };
    if (!within(curl.radius, 1) || !within(curl.turns, kMaxCurlTurns) ||
        !within(curl.jitter, 1)) {
        throw std::invalid_argument("wrapped_in_curls: a setting is out of range");
    }
    const double max_turns = curl.turns * (1 + kMaxDeviations * curl.jitter);
    const int n = std::max(kMinPoints, int(std::ceil(kPointsPerTurn * max_turns)));
    std::vector<std::vector<Vec3f>> wound(strands.size());
    cancellable_for(std::size_t(0), strands.size(), [&](std::size_t i) {
        const auto curve = strand_curve(strands, i);
        if (!curve) return;
        const SampledCurve axis = resample(*curve, n);
        const auto frames =
            rotation_minimizing_frames(axis.positions, axis.tangents, Vec3::UnitX());
        const DrawnCurl drawn = drawn_curl(curl, seed, i);
        wound[i].reserve(n + 1);
        for (int j = 0; j <= n; ++j) {
            const double t = double(j) / n,
                         angle = (2 * kPi) * drawn.turns * t + drawn.phase;
            const double radius = curl.radius * axis.length * std::min(1.0, t / kGrowth);
            const Vec3 off =
                std::cos(angle) * frames[j].col(1) + std::sin(angle) * frames[j].col(2);
            wound[i].push_back((axis.positions[j] + radius * off).cast<float>());
        }
    });
    Strands out;
    out.default_thickness = strands.default_thickness;
    out.default_transparency = strands.default_transparency;
    out.default_colour = strands.default_colour;
    std::size_t total = 0;
    for (const auto& points : wound) total += points.size();
    if (total > std::numeric_limits<std::uint32_t>::max()) {
        throw InputError(
            "curls of so many turns have more points than 32 bits can count");
    }
    out.points.reserve(total);
    for (auto& points : wound) {
        if (points.empty()) continue;
        out.points.insert(out.points.end(), points.begin(), points.end());
        out.first.push_back(std::uint32_t(out.points.size()));
        points = {};
    }
    return out;
}

}  // namespace lancret
