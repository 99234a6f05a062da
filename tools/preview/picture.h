#pragma once
// One picture of lancret preview: strands grown and handed to the tracer, then seen from
// a camera.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render_test/plugin/strands.h"
#include "render_test/settings/preview.h"
#include "tools/job.h"

namespace lancret {

/// What one picture cost, s and bytes.
struct PictureCost {
    double bind = 0, expand = 0, bvh = 0, render = 0;
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
    double frame = 0;
    Curves curves;
    std::optional<TriangleMesh> body;
    std::vector<float> true_radii;  ///< of thin strands drawn wider, else empty
};

/// The times of a scene of these moments, which must outlive them.
std::vector<SceneTime> scene_times(const std::vector<ShownTime>& moments);

/// The layers that a picture's files hold and `denoise` needs.
Channels channels_of(const PictureFiles& files, bool denoise);

/// Grows the children at the `times` of a picture, one without motion blur; `cameras` are
/// those that a thin strand is drawn wide enough for, in strands of `shape` (none: as
/// wide strands need). Throws InputError.
std::vector<ShownTime> grow(const PluginGroom& groom, const PluginStrands& strands,
                            const std::vector<double>& times, const Job& job,
                            std::span<const Camera> cameras,
                            const std::optional<CurveShape>& shape, PictureCost& cost);

/// Makes what was grown ready for any number of views; `moments` must outlive it.
HairScene scene_of(const std::vector<ShownTime>& moments, const Job& job,
                   PictureCost& cost);

/// Whether guides and head are at `times` just where they were when `moments` were grown,
/// so that these can be shown again. Throws InputError.
bool as_before(const std::vector<ShownTime>& moments, const PluginGroom& groom,
               const std::vector<double>& times);

/// Writes a picture's files, its deep one where it has one. Throws InputError.
void write_picture(const PictureFiles& files, const Image& image,
                   const Vec3f& background);

/// Renders and writes one picture, and gives it; a progressive one again and again, the
/// file replaced each time, and its deep one once. That of a check view has its legend.
/// Throws InputError.
Image shoot(const RenderScene& scene, const Camera& camera,
            const PreviewSettings& settings, bool progressive, const std::string& title,
            const PictureFiles& files, PictureCost& cost);

/// Adds to stats["bytes"] what a picture's memory is made of: bvh, per_time (ids and
/// control points of one time), widths (of thin strands), each also by the strand, and
/// process, what was there before the groom was read.
void add_memory_stats(nlohmann::json& stats, const std::vector<ShownTime>& moments,
                      std::size_t bvh, std::size_t process);

/// The camera gone round the axis through `centre` by `angle`, radian.
Camera turned(const Camera& camera, const Vec3f& centre, const Vec3f& up, float angle);

}  // namespace lancret
