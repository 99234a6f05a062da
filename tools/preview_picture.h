#pragma once
// One picture of lancret preview: strands grown and handed to the tracer, then seen from
// a camera.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
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

/// The box of the guides: what a groom means to be, whatever a stray child does.
Eigen::AlignedBox3f extent(const GuideProfiles<float>& profiles, const Guides& guides,
                           float length_scale);

/// The times of a scene of these moments, which must outlive them.
std::vector<SceneTime> scene_times(const std::vector<ShownTime>& moments);

/// The layers that a picture's files hold and `denoise` needs.
Channels channels_of(const PictureFiles& files, bool denoise);

/// Grows the children at the moments of a picture, one without motion blur, and makes
/// them ready for any number of views; `cameras` are those that a thin strand is drawn
/// wide enough for. `moments` must outlive what it gives. Where this is the `last` time,
/// what only growing needs is let go before the BVH is built. Throws InputError.
HairScene grow(Generator& generator, RestPlaces& rest, const ChosenFrames& chosen,
               const std::vector<double>& times, const Job& job,
               std::span<const Camera> cameras, std::vector<ShownTime>& moments,
               PictureCost& cost, bool last);

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

/// Adds to stats["bytes"] what a picture's memory is made of: bvh, per_time (control
/// points of one time), widths (of thin strands), each also by the strand, and process,
/// what was there before the groom was read.
void add_memory_stats(nlohmann::json& stats, const std::vector<ShownTime>& moments,
                      std::size_t bvh, std::size_t process);

/// The camera gone round the axis through `centre` by `angle`, radian.
Camera turned(const Camera& camera, const Vec3f& centre, const Vec3f& up, float angle);

}  // namespace lancret
