#pragma once
// One picture of lancret preview: a scene seen from a camera, rendered into its files.

#include <filesystem>
#include <string>

#include "render_test/settings/preview.h"
#include "tools/preview/picture_cost.h"

namespace lancret {

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
