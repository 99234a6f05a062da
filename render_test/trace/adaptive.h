#pragma once
// The number of samples that each pixel needs for a picture of a given noise.
//
// Noise is the root mean square error of luminance over the picture's mean luminance,
// both over covered pixels. It is distributed to look uniform: the error allowed for a
// pixel grows with the root of its luminance, roughly as the tolerance of the eye. The
// squared errors allowed for pixels add up to that of the picture, so the picture meets
// the target if every pixel does.

#include <cstdint>
#include <vector>

#include "render_test/trace/film.h"

namespace lancret {

/// Samples that each pixel needs for a relative `noise` > 0 of the picture, at most
/// `limit`; [pixels]. Estimated from the variance of all samples in the 7 x 7 pixels
/// around it, because the few samples of one pixel may miss rare bright paths. The film
/// must have squares and at least two samples in every pixel.
std::vector<std::uint32_t> samples_needed(const Film& film, float noise,
                                          std::uint32_t limit);

}  // namespace lancret
