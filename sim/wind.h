#pragma once
// The air that hair stands in.

#include <cstdint>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// A wind as a groom describes it.
struct WindSettings {
    Vec3 mean = Vec3::Zero();  ///< cm/s
    /// Root mean square of the speed that turbulence adds, cm/s: of the whole vector, so
    /// 1 / sqrt(3) of it in each direction.
    double turbulence = 0;
    double length_scale = 20;  ///< wavelength of the largest waves, cm
    double time_scale = 0.5;   ///< their period, to one who drifts with the mean wind, s
    int octaves = 3;           ///< each of half the wavelength of the one before
    int waves_per_octave = 8;
    std::uint64_t seed = 0;
};

/// A travelling plane wave of air, amplitude cos(wave . x - frequency t + phase).
struct WindWave {
    Vec3 wave;         ///< 1/cm
    Vec3 amplitude;    ///< cm/s, across the wave: so the field has no divergence
    double frequency;  ///< rad/s
    double phase;      ///< rad
};

/// The velocity of air anywhere at any time. Made by make_wind.
struct Wind {
    Vec3 mean = Vec3::Zero();     ///< cm/s
    std::vector<WindWave> waves;  ///< octave by octave
};

/// A wind of plane waves whose directions, polarisations and phases are random, by hash
/// alone. An octave of wavelength l has speeds ~ l^(1/3) and periods ~ l^(2/3), as in the
/// inertial range of turbulence (Kolmogorov 1941); all waves are carried by the mean wind
/// (Taylor's frozen gusts) and pass through the air beside. The mean square over space
/// and time is turbulence^2 for any seed. No waves where turbulence is 0. Throws
/// std::invalid_argument where a number is not finite or beyond 1e9, turbulence is below
/// 0, a scale is not 1e-6 or more, or there are not 1 to 10 octaves of 1 to 100 waves.
Wind make_wind(const WindSettings& settings);

/// The air's velocity at x (cm) and time t (s), cm/s. Costs a cosine a wave, allocates
/// nothing.
Vec3 wind_velocity(const Wind& wind, const Vec3& x, double t);

}  // namespace lancret
