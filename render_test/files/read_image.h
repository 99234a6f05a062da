#pragma once
// Textures from image files.

#include <filesystem>

#include "render_test/image/texture.h"

namespace lancret {

/// Reads a colour image as linear RGB: 8-bit and 16-bit integers are taken as sRGB, grey
/// as equal RGB, negative values as zero. Throws InputError that names the path.
Texture read_texture(const std::filesystem::path& path);

}  // namespace lancret
