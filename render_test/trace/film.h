#pragma once
// A picture in progress: sums over the samples of each pixel so far.

#include <cstdint>
#include <vector>

#include "render_test/image/image.h"
#include "render_test/trace/integrator.h"

namespace lancret {

/// The optional layers of a picture.
struct Channels {
    bool variance = false;  ///< of the mean of each pixel
    bool motion = false;
    bool mattes = false;  ///< objects and body
    bool deep = false;
    bool value = false;  ///< figure of a check view
};

/// Sums over the samples so far, with the requested layers. Pixels are independent: any
/// number of threads may add samples to different pixels.
struct Film {
    Image sums;  ///< rgba's alpha is the coverage; depth is the minimum
    std::vector<std::uint32_t> hits;     ///< [pixels] samples that hit something
    std::vector<std::uint32_t> samples;  ///< [pixels] all samples
    /// [pixels], or empty if not requested: sums of the squared differences of the
    /// samples' rgba from their mean so far.
    std::vector<Eigen::Vector4f> squares;
    float deep_gap = 0;                 ///< of merge(), relative to the depth
    std::uint64_t rays = 0, paths = 0;  ///< traced so far

    Film(int width, int height, const Channels& channels);
};

/// The result of a path, as input of the film.
struct Sighting {
    const PathResult& path;
    float depth = 0;  ///< of the first hit, along the viewing direction, cm
    Vec3f direction = Vec3f::UnitZ();  ///< of the ray
    Vec2f motion = Vec2f::Zero();      ///< of the first hit, pixels
};

/// Adds a sample to a pixel, except for deep samples. To save allocations, those are
/// gathered for a whole pixel and then added.
void add_sample(Film& film, std::size_t pixel, const Sighting& sighting);

/// Appends the deep sample of a path, if it hit something.
void gather_deep(const Sighting& sighting, std::vector<DeepSample>& gathered);
/// Merges `gathered` into the deep samples of a pixel and clears it.
void add_deep(Film& film, std::size_t pixel, std::vector<DeepSample>& gathered);

/// The variance of a pixel's mean: that of its samples over their number; zero for a
/// single sample. Samples of a pixel are stratified, so this is an upper bound, and the
/// true variance is smaller in smooth pixels. The film must have `squares`.
Eigen::Vector4f variance_of_mean(const Film& film, std::size_t pixel);

/// Replaces the sums of a pixel by means in `image`, a copy of the film's sums. Throws
/// std::runtime_error if its colour is not a finite number.
void finish_pixel(const Film& film, std::size_t pixel, Image& image);

}  // namespace lancret
