#pragma once
// What a host asks of a chunk.

#include <algorithm>
#include <vector>

#include "procedural/abi/handles.h"
#include "procedural/curves/control_points.h"

namespace lancret::abi {

/// Times of one call.
inline constexpr std::size_t kMaxTimes = 256;

/// Options that were looked at, for one chunk.
struct Request {
    int basis = 0;  ///< LANCRET_LINEAR, ...
    std::vector<double>
        frames;  ///< at least one: what is there at each time: see OpenGroom::frame_at
    CurveBasis curve = CurveBasis::linear;         ///< the same
    float max_error = 0;                           ///< cm; 0: the groom's own
    std::shared_ptr<const StrandClasses> classes;  ///< how finely strands are cut
    double density = 1;
    std::uint32_t attributes = 0;
    double scale = 1;  ///< units of what is given back in a cm

    /// Whether all times are one.
    bool is_still() const {
        return std::ranges::count(frames, frames[0]) == std::ptrdiff_t(frames.size());
    }
    bool wants(std::uint32_t attribute) const { return attributes & attribute; }
};

/// Null options are the defaults. Throws BadCall.
Request read_request(const OpenGroom& groom, std::uint32_t chunk,
                     const lancret_options* options);

}  // namespace lancret::abi
