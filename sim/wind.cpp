#include "sim/wind.h"

#include <cmath>

#include "guides/base/errors.h"
#include "guides/base/hash.h"

namespace lancret {

namespace {

constexpr double kTwoPi = 2 * kPi;

/// The random numbers of a wave.
enum Salt : std::uint64_t { kHeight, kAzimuth, kPolarisation, kPhase };

void validate(const WindSettings& s) {
    // Written so that a NaN fails.
    const auto within = [](double x, double low) { return x >= low && x <= 1e9; };
    require(s.mean.allFinite() && within(s.mean.cwiseAbs().maxCoeff(), 0),
            "make_wind: the mean wind must be within 1e9 cm/s");
    require(within(s.turbulence, 0) && within(s.length_scale, 1e-6) &&
                within(s.time_scale, 1e-6),
            "make_wind: turbulence must be at least 0, scales at least 1e-6, all at most "
            "1e9");
    require(s.octaves >= 1 && s.octaves <= 10 && s.waves_per_octave >= 1 &&
                s.waves_per_octave <= 100,
            "make_wind: expected 1 to 10 octaves of 1 to 100 waves");
}

}  // namespace

Wind make_wind(const WindSettings& settings) {
    validate(settings);
    Wind wind{settings.mean, {}};
    if (settings.turbulence == 0) return wind;

    // A wave of amplitude a adds a^2 / 2 to the mean square.
    double square = 0;
    for (int octave = 0; octave < settings.octaves; ++octave) {
        square += settings.waves_per_octave * std::exp2(-2.0 * octave / 3) / 2;
    }
    const double unit = settings.turbulence / std::sqrt(square);
    for (int octave = 0; octave < settings.octaves; ++octave) {
        const double number = kTwoPi * std::exp2(octave) / settings.length_scale;
        const double rate = kTwoPi * std::exp2(2.0 * octave / 3) / settings.time_scale;
        for (int i = 0; i < settings.waves_per_octave; ++i) {
            const std::uint64_t id = wind.waves.size();
            const auto random = [&](Salt salt) {
                return unit_double(hash_bits(settings.seed, id, salt));
            };
            const double z = 2 * random(kHeight) - 1, ring = std::sqrt(1 - z * z);
            const double azimuth = kTwoPi * random(kAzimuth);
            const Vec3 direction(ring * std::cos(azimuth), ring * std::sin(azimuth), z);
            const Vec3 across = direction.unitOrthogonal();
            const double turn = kTwoPi * random(kPolarisation);
            WindWave wave;
            wave.wave = number * direction;
            wave.amplitude =
                unit * std::exp2(-octave / 3.0) *
                (std::cos(turn) * across + std::sin(turn) * direction.cross(across));
            wave.frequency = rate + wave.wave.dot(settings.mean);
            wave.phase = kTwoPi * random(kPhase);
            wind.waves.push_back(wave);
        }
    }
    return wind;
}

Vec3 wind_velocity(const Wind& wind, const Vec3& x, double t) {
    Vec3 sum = wind.mean;
    for (const WindWave& w : wind.waves) {
        sum += w.amplitude * std::cos(w.wave.dot(x) - w.frequency * t + w.phase);
    }
    return sum;
}

}  // namespace lancret
