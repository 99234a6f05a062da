#pragma once
// One picture of lancret preview: strands grown and handed to the tracer, then seen from
// a camera.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render_test/preview_settings.h"
#include "tools/frames.h"

namespace lancret {

/// What one picture cost, s and bytes.
struct PictureCost {
    double expand = 0, bvh = 0, render = 0;
    double first = 0;  ///< of `render`, until the first picture was there
    std::uint64_t rays = 0, paths = 0;
    std::size_t bvh_bytes = 0;
};

/// Where a picture goes.
struct PictureFiles {
    std::filesystem::path picture;
    std::filesystem::path deep;  ///< empty: no deep picture
};

/// The children and the head at each time of a shutter.
struct ShownTime {
    FrameState state;
    Curves curves;
    std::optional<TriangleMesh> body;
    std::vector<float> true_radii;  ///< of thin strands drawn wider, else empty
};

/// The times of a scene of these moments, which must outlive them.
std::vector<SceneTime> scene_times(const std::vector<ShownTime>& moments);

/// The layers that a picture's files hold and `denoise` needs.
Channels channels_of(const PictureFiles& files, bool denoise);

/// Grows the children at the moments of a picture, one without motion blur, and makes
/// them ready for any number of views; `cameras` are those that a thin strand is drawn
/// wide enough for. `moments` must outlive what it gives. Throws InputError.
HairScene grow(Generator& generator, const RestPlaces& rest, const ChosenFrames& chosen,
               const std::vector<double>& times, const Job& job,
               std::span<const Camera> cameras, std::vector<ShownTime>& moments,
               PictureCost& cost);

/// Whether guides and head are at `times` just where they were when `moments` were grown,
/// so that what grow gave can be shown again. Throws InputError.
bool as_before(const std::vector<ShownTime>& moments, const RestPlaces& rest,
               const ChosenFrames& chosen, const std::vector<double>& times,
               const Job& job);

/// Writes a picture's files, its deep one where it has one. Throws InputError.
void write_picture(const PictureFiles& files, const Image& image,
                   const Vec3f& background);

/// Renders and writes one picture, and gives it; a progressive one again and again, the
/// file replaced each time, and its deep one once. That of a check view has its legend.
/// Throws InputError.
Image shoot(const RenderScene& scene, const Camera& camera,
            const PreviewSettings& settings, bool progressive, const std::string& title,
            const PictureFiles& files, PictureCost& cost);

/// The camera gone round the axis through `centre` by `angle`, radian.
Camera turned(const Camera& camera, const Vec3f& centre, const Vec3f& up, float angle);

}  // namespace lancret
