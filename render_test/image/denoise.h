#pragma once
// Reduces the noise of a finished image, guided by its other layers.

#include "render_test/image/image.h"

namespace lancret {

struct DenoiseSettings {
    int radius = 4;         ///< of filter windows, pixels
    int shrink_radius = 2;  ///< of the windows that separate detail from noise, pixels
    float ridge = 1e-3f;    ///< regularisation of slopes, > 0
};

/// A guided filter [He, Sun and Tang 2013, "Guided image filtering", eqs. 4 to 8 and 14]
/// of colour, guided by coverage, normal, tangent and depth: in each window colour is the
/// linear function of
///   coverage * (1, N.x, N.y, N.z, T.x, T.y, T.z, depth)
/// with the least squared error, and a pixel is the mean over all its windows. The
/// remainder is noise and detail: the share by which it exceeds `variance` in the window
/// is added back, as by Wiener's filter.
///
/// Coverage is unchanged, and pixels without coverage have no colour. Other layers are
/// unchanged, so `variance` remains that of the input. Throws std::invalid_argument if
/// the image has no variance. Same bits for any number of threads.
void denoise(Image& image, const DenoiseSettings& settings = {});

}  // namespace lancret
