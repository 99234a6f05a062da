#pragma once
// The wind that hair moves in.

#include <cstdint>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// The parameters of a wind.
struct WindSettings {
    Vec3 mean = Vec3::Zero();  ///< cm/s
    /// Root mean square of the turbulent velocity vector, cm/s; 1 / sqrt(3) of it along
    /// each axis.
    double turbulence = 0;
    double length_scale = 20;  ///< wavelength of the largest waves, cm
    double time_scale = 0.5;   ///< their period, as seen drifting with the mean wind, s
    int octaves = 3;           ///< each with half the wavelength of the previous one
    int waves_per_octave = 8;
    std::uint64_t seed = 0;
};

/// A travelling plane wave of air, amplitude cos(wave . x - frequency t + phase).
struct WindWave {
    Vec3 wave;         ///< 1/cm
    Vec3 amplitude;    ///< cm/s, perpendicular to the wave: no divergence
    double frequency;  ///< rad/s
    double phase;      ///< rad
};

/// The velocity of the air at all positions and times, as returned by make_wind.
struct Wind {
    Vec3 mean = Vec3::Zero();     ///< cm/s
    std::vector<WindWave> waves;  ///< octave by octave
};

/// A wind of plane waves whose directions, polarisations and phases are hashes of the
/// seed. An octave of wavelength l has speeds ~ l^(1/3) and periods ~ l^(2/3), as in the
/// inertial range of turbulence (Kolmogorov 1941). All waves are carried by the mean wind
/// (Taylor's frozen turbulence) and also travel relative to the air. The mean square over
/// space and time is turbulence^2 for any seed; no waves if turbulence is 0. Throws
/// std::invalid_argument if a number is not finite or beyond 1e9, turbulence is below 0,
/// a scale is below 1e-6, or there are not 1 to 10 octaves of 1 to 100 waves.
Wind make_wind(const WindSettings& settings);

/// The velocity of the air at x (cm) and time t (s), cm/s. Costs one cosine per wave and
/// does not allocate.
Vec3 wind_velocity(const Wind& wind, const Vec3& x, double t);

}  // namespace lancret
