#pragma once
// Pictures of many parts, and deep ones, by OpenEXR.

#include <filesystem>

#include "render_test/image/image.h"

namespace lancret {

/// Writes a part for each layer that `image` has, ZIP compressed:
///   rgba            R G B A (half)
///   depth           Z (float), infinite where there is nothing
///   N, T            N.X N.Y N.Z, T.X T.Y T.Z (half)
///   id              id (uint)
///   value           value (float), of a check view
///   motion          motion.X motion.Y (float)
///   variance        variance.R .G .B .A (float)
///   CryptoObject    CryptoObject00.R .. CryptoObject02.A (float): ids and shares of the
///                   six that cover most
///   CryptoMaterial  CryptoMaterial00.R .. .A (float): the same of hair and head
/// The attributes of Cryptomatte are in rgba, where most readers look for them, and in
/// their own parts. Throws whatever OpenEXR throws.
void write_exr(const std::filesystem::path& path, const Image& image);

/// Writes `image.deep` as one part of deep scan lines, ZIPS compressed: R G B A (half,
/// times alpha), Z, ZBack (float, the same: samples have no thickness) and id (uint), as
/// composited() gives them. Throws InputError where the extension is not .exr or the
/// file cannot be written, std::invalid_argument where there are no deep samples.
void write_deep_exr(const std::filesystem::path& path, const Image& image);

}  // namespace lancret
