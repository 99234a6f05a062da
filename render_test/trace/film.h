#pragma once
// A picture on its way: what the samples of each pixel come to so far.

#include <cstdint>
#include <vector>

#include "render_test/image/image.h"
#include "render_test/trace/path_tracer.h"

namespace lancret {

/// The layers of a picture that are kept only where asked for.
struct Channels {
    bool variance = false;  ///< of each pixel's mean
    bool motion = false;
    bool mattes = false;  ///< objects and body
    bool deep = false;
    bool value = false;  ///< of a check view
};

/// Sums over the samples so far in place of means; the layers' sums of `sums` are there
/// where they are asked for. Each pixel is its own: any number of
/// threads may add samples to different ones.
struct Film {
    Image sums;                       ///< rgba's last is the coverage; depth is the least
    std::vector<std::uint32_t> hits;  ///< [pixels] samples that met something
    std::vector<std::uint32_t> samples;  ///< [pixels] all of them
    /// [pixels], or empty where not asked for: squared differences of the samples' rgba
    /// from their mean so far, summed.
    std::vector<Eigen::Vector4f> squares;
    float deep_gap = 0;                 ///< of merge(), a share of the depth
    std::uint64_t rays = 0, paths = 0;  ///< traced for all of it

    Film(int width, int height, const Channels& channels);
};

/// What a path has found, as the film takes it.
struct Sighting {
    const PathResult& path;
    float depth = 0;  ///< of the first hit, along the direction of sight, cm
    Vec3f direction = Vec3f::UnitZ();  ///< the ray's
    Vec2f motion = Vec2f::Zero();      ///< of the first hit, pixels
};

/// Adds to a pixel. All but deep samples, which would have
/// to be allocated for each: they are gathered for a pixel and then added.
void add_sample(Film& film, std::size_t pixel, const Sighting& sighting);

/// Appends what one sample adds to its pixel's deep samples, nothing where it met none.
void gather_deep(const Sighting& sighting, std::vector<DeepSample>& gathered);
/// Merges `gathered` into those of a pixel and empties it.
void add_deep(Film& film, std::size_t pixel, std::vector<DeepSample>& gathered);

/// The variance of a pixel's mean: that among its samples over their number; zero of one
/// sample, which tells nothing. Samples of a pixel are spread more evenly than by chance,
/// so the truth is at most this, and is less where the pixel is smooth. The film has
/// `squares`.
Eigen::Vector4f variance_of_mean(const Film& film, std::size_t pixel);

/// The means of a pixel in place of its sums, `image` a copy of the film's. Throws
/// std::runtime_error where its colour is not a finite number.
void finish_pixel(const Film& film, std::size_t pixel, Image& image);

}  // namespace lancret
