#pragma once
// Less noise in a finished picture, by what its other layers know.

#include "render_test/image/image.h"

namespace lancret {

struct DenoiseSettings {
    int radius = 4;         ///< of windows, pixels
    int shrink_radius = 2;  ///< of those in which detail is told from noise
    float ridge = 1e-3f;    ///< by which slopes are held back, > 0
};

/// A guided filter [He, Sun and Tang 2013, "Guided image filtering", eqs. 4 to 8 and 14]
/// of colour, the guides being coverage, normal, tangent and depth: in each window colour
/// is the linear function of
///   coverage * (1, N.x, N.y, N.z, T.x, T.y, T.z, depth)
/// with the least squared error, and a pixel the mean of all its windows. What that
/// leaves over is noise and detail: of it, as much is put back as in the window exceeds
/// what `variance` says is noise, as Wiener's filter would have it.
///
/// Coverage stays as it is; colour without coverage is none. Other layers stay, so
/// `variance` is that of the picture before. Throws std::invalid_argument where the
/// picture has no variance. The same bits for any number of threads.
void denoise(Image& image, const DenoiseSettings& settings = {});

}  // namespace lancret
