#pragma once
// One picture of lancret preview: a scene seen from a camera, rendered into its files.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "render_test/settings/preview.h"

namespace lancret {

/// The cost of one picture, or of several together. Times in seconds.
struct PictureCost {
    double bind = 0, expand = 0, bvh = 0, render = 0;
    double first = 0;  ///< the part of `render` until the first picture was written
    std::uint64_t rays = 0, paths = 0;
    std::size_t bvh_bytes = 0;
};

/// Adds the cost of a picture to the total, whose `first` is that of the first picture
/// and whose `bvh_bytes` is the maximum.
void add_cost(const PictureCost& cost, bool is_first, PictureCost& total);

/// The files of a picture.
struct PictureFiles {
    std::filesystem::path picture;
    std::filesystem::path deep;  ///< empty: no deep image
};

/// The layers that a picture's files and `denoise` need.
Channels channels_of(const PictureFiles& files, bool denoise);

/// One picture to render. References must outlive it.
struct PictureJob {
    const RenderScene& scene;
    const Camera& camera;
    const PreviewSettings& settings;
    const PictureFiles& files;
    std::string title;  ///< of the progress bar
    bool progressive = false;
};

/// Renders and writes one picture, and returns it. A progressive one is written
/// repeatedly, its deep image once. The picture of a check view has its legend. Throws
/// InputError.
Image shoot(const PictureJob& job, PictureCost& cost);

/// Writes all files of a picture. Throws InputError.
void write_picture(const PictureFiles& files, const Image& image,
                   const Vec3f& background);

}  // namespace lancret
