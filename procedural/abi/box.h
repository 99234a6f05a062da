#pragma once
// Boxes of chunks.

#include <Eigen/Geometry>

#include "procedural/abi/request.h"

namespace lancret::abi {

/// A box that holds the chunk with its widths at the options' times and between them, in
/// the options' unit. Empty where no strand is grown. Throws BadCall, InputError.
Eigen::AlignedBox3f bound_box(const OpenGroom& groom, std::uint32_t chunk,
                              const lancret_options* options, int kind);

}  // namespace lancret::abi
