#pragma once
// Deep images as OpenEXR.

#include <filesystem>

#include "render_test/image/image.h"

namespace lancret {

/// Writes `image.deep` as one part of deep scan lines, ZIPS compressed: R G B A (half,
/// times alpha), Z, ZBack (float, equal: samples have no thickness) and id (uint), as
/// returned by composited(). Throws InputError if the extension is not .exr or the file
/// cannot be written, std::invalid_argument if there are no deep samples.
void write_deep_exr(const std::filesystem::path& path, const Image& image);

}  // namespace lancret
