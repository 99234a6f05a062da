#pragma once
// Bounding boxes of chunks.

#include <Eigen/Geometry>

#include "procedural/abi/request.h"

namespace lancret::abi {

/// The box of chunk `index` with its widths, at the times of the options and between
/// them, in the unit of the options. Empty if no strand is grown. `kind` is LANCRET_REACH
/// or LANCRET_TIGHT. Throws BadCall, InputError, Cancelled.
Eigen::AlignedBox3f box_of_chunk(const OpenGroom& groom, std::uint32_t index,
                                 const lancret_options* options, int kind);

}  // namespace lancret::abi
