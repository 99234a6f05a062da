#pragma once
// Pictures in memory and on disk. image*.cpp alone know OpenImageIO and OpenEXR.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "guides/base/types.h"
#include "render_test/image/deep.h"
#include "render_test/image/ranked_ids.h"
#include "render_test/image/texture.h"

namespace lancret {

inline constexpr std::uint32_t kNothingId = 0xffffffffu, kMeshId = 0xfffffffeu;

/// A render with its layers, row after row from the top. Layers other than rgba are means
/// over the samples of a pixel that hit something (zero where none did), but depth is the
/// least of them and `id` that of the first sample. Layers that nobody asked for
/// (Channels) are empty.
struct Image {
    int width = 0, height = 0;
    std::vector<Eigen::Vector4f> rgba;      ///< linear, times coverage; coverage
    std::vector<float> depth;               ///< nearest along the direction of sight, cm
    std::vector<Vec3f> normal;              ///< towards the viewer, world axes
    std::vector<Vec3f> tangent;             ///< root to tip, world axes; zero on a mesh
    std::vector<std::uint32_t> id;          ///< strand, kMeshId or kNothingId
    std::vector<Eigen::Vector4f> variance;  ///< of rgba, the pixel's mean (film.h)
    std::vector<Vec2f> motion;              ///< pixels, right and up (motion.h)
    std::vector<RankedIds> objects;  ///< shares of the pixel of strands and kMeshId
    std::vector<float> body;         ///< share of the pixel of the mesh
    std::vector<std::vector<DeepSample>> deep;  ///< sorted by id and depth
    std::vector<float> value;                   ///< of a check view, at the first sample

    Image() = default;
    Image(int w, int h);
};

/// Writes by extension, beside and then renamed. Throws InputError that names the path.
///   .exr  one part for each layer (image_exr.h)
///   .png  8 bits a channel, sRGB. With a `background` (linear) the picture is laid over
///         it; else it has alpha, not premultiplied.
void write_image(const std::filesystem::path& path, const Image& image,
                 const std::optional<Vec3f>& background = std::nullopt);

/// Reads any colour image as linear RGB: 8-bit and 16-bit integers are taken as sRGB,
/// grey as equal RGB, negative values as zero. Throws InputError that names the path.
Texture read_colour_map(const std::filesystem::path& path);

/// Writes `text` onto the picture in an opaque linear colour, from (x, y) in pixels, y
/// that of the base line; `size` is the letters' height in pixels. False, and nothing is
/// written, where there is no font to do it with.
bool draw_text(Image& image, int x, int y, const std::string& text, int size,
               const Vec3f& colour);

/// The colours of the picture at another size, each of its pixels the mean of those that
/// it stands for; no other layer.
Image reduced(const Image& image, int width, int height);

/// The sRGB code, 0..1, of a linear value; clamped.
float srgb_of_linear(float linear);
float linear_of_srgb(float code);

}  // namespace lancret
