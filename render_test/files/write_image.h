#pragma once
// Image files.

#include <filesystem>
#include <optional>

#include "render_test/image/image.h"

namespace lancret {

/// Writes an image in the format of its extension: beside the path, then renamed. Throws
/// InputError that names the path.
///   .exr  one part per layer (exr.h)
///   .png  8 bits per channel, sRGB. With a `background` (linear) the image is composited
///         over it; else it has straight alpha.
void write_image(const std::filesystem::path& path, const Image& image,
                 const std::optional<Vec3f>& background = std::nullopt);

}  // namespace lancret
