#pragma once
// The options of a chunk request.

#include <algorithm>
#include <vector>

#include "procedural/abi/handles.h"
#include "procedural/curves/control_points.h"

namespace lancret::abi {

/// Maximum number of times per call.
inline constexpr std::size_t kMaxTimes = 256;

/// Validated options for one chunk.
struct Request {
    int basis = 0;                          ///< LANCRET_LINEAR, ...
    CurveBasis curve = CurveBasis::linear;  ///< the same
    std::vector<double> frames;  ///< frame numbers, at least one; see OpenGroom::frame_at
    float max_error = 0;         ///< cm; 0: the groom's tolerance
    std::shared_ptr<const StrandClasses> classes;  ///< interval counts
    double density = 1;
    std::uint32_t attributes = 0;  ///< LANCRET_TANGENTS | ...
    double scale = 1;              ///< output units per cm

    /// Whether all times are the same frame number.
    bool is_still() const {
        return std::ranges::count(frames, frames[0]) == std::ptrdiff_t(frames.size());
    }
    bool wants(std::uint32_t attribute) const { return attributes & attribute; }
};

/// Validates the options of chunk `index`; null options are the defaults. Throws BadCall,
/// InputError, Cancelled.
Request read_request(const OpenGroom& groom, std::uint32_t index,
                     const lancret_options* options);

}  // namespace lancret::abi
