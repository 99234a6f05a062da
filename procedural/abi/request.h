#pragma once
// What a host asks of a chunk.

#include <vector>

#include "procedural/abi/handles.h"
#include "procedural/control_points.h"

namespace lancret::abi {

/// Options that were looked at, for one chunk.
struct Request {
    std::vector<double> times;  ///< frames, at least one
    int basis = 0;              ///< LANCRET_LINEAR, ...
    int intervals = 0;          ///< a strand
    double density = 1;
    std::uint32_t attributes = 0;
    double scale = 1;  ///< units of what is given back in a cm

    bool wants(std::uint32_t attribute) const { return attributes & attribute; }
};

/// Null options are the defaults. Throws BadCall.
Request read_request(const Prepared& groom, std::uint32_t chunk,
                     const lancret_options* options);

}  // namespace lancret::abi
