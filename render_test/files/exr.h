#pragma once
// Multi-part OpenEXR images.

#include <filesystem>

#include "render_test/image/image.h"

namespace lancret {

/// Writes one part per layer of `image`, ZIP compressed:
///   rgba            R G B A (half)
///   depth           Z (float), infinite where nothing was hit
///   N, T            N.X N.Y N.Z, T.X T.Y T.Z (half)
///   id              id (uint)
///   value           value (float), of a check view
///   motion          motion.X motion.Y (float)
///   variance        variance.R .G .B .A (float)
///   CryptoObject    CryptoObject00.R .. CryptoObject02.A (float): ids and shares of the
///                   six objects that cover most
///   CryptoMaterial  CryptoMaterial00.R .. .A (float): the same for hair and head
/// Cryptomatte's attributes are both in rgba, where most readers look for them, and in
/// its own parts. Throws the exceptions of OpenEXR.
void write_exr(const std::filesystem::path& path, const Image& image);

}  // namespace lancret
