#pragma once
// Images in memory.

#include <cstdint>
#include <vector>

#include "guides/base/types.h"
#include "render_test/image/deep.h"
#include "render_test/image/ranked_ids.h"

namespace lancret {

inline constexpr std::uint32_t kNothingId = 0xffffffffu, kMeshId = 0xfffffffeu;

/// A render with its layers, row by row from the top. Layers other than rgba are means
/// over the samples of a pixel that hit something (zero if none did), except that depth
/// is their minimum and `id` that of the first sample. Layers that were not requested
/// (Channels) are empty.
struct Image {
    int width = 0, height = 0;
    std::vector<Eigen::Vector4f> rgba;      ///< linear, times coverage; coverage
    std::vector<float> depth;               ///< nearest along the viewing direction, cm
    std::vector<Vec3f> normal;              ///< towards the viewer, world axes
    std::vector<Vec3f> tangent;             ///< root to tip, world axes; zero on a mesh
    std::vector<std::uint32_t> id;          ///< strand, kMeshId or kNothingId
    std::vector<Eigen::Vector4f> variance;  ///< of rgba, the pixel's mean (film.h)
    std::vector<Vec2f> motion;              ///< pixels, right and up (motion.h)
    std::vector<RankedIds> objects;         ///< shares of the pixel by strand and kMeshId
    std::vector<float> body;                ///< share of the pixel covered by the mesh
    std::vector<std::vector<DeepSample>> deep;  ///< sorted by id and depth
    std::vector<float> value;  ///< figure of a check view, at the first sample

    Image() = default;
    Image(int w, int h);
};

/// The sRGB code, 0..1, of a linear value; clamped.
float srgb_of_linear(float linear);
float linear_of_srgb(float code);

}  // namespace lancret
