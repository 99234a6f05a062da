#pragma once
// How many samples each pixel needs for a picture of a given noise.
//
// Noise is the root of the mean square of the luminance's error over the picture's mean
// luminance, both over what is covered. It is spread so that it looks even: the error
// that a pixel may have grows with the root of its luminance, about as the eye's own
// does. The squares of what pixels may have add up to the picture's, so the whole meets
// the target where each does.

#include <cstdint>
#include <vector>

#include "render_test/trace/film.h"

namespace lancret {

/// Samples that each pixel needs for a relative `noise` > 0 of the picture, at most
/// `most`; [pixels]. Judged by the variance among all samples of the 7 x 7 pixels around
/// it, for one pixel's few samples may miss what is seldom and bright. The film has
/// squares, and two samples in every pixel.
std::vector<std::uint32_t> samples_needed(const Film& film, float noise,
                                          std::uint32_t most);

}  // namespace lancret
