#pragma once
// As much of a RIB reader as it takes to look at what was written.

#include <array>
#include <map>
#include <string>
#include <vector>

namespace lancret {

/// A Curves request.
struct RibCurves {
    std::string type, wrap;
    std::vector<int> counts;
    std::map<std::string, std::vector<float>> values;  ///< by declaration
};

/// What stands between the AttributeBegin and AttributeEnd of one procedural.
struct RibChunk {
    std::array<float, 6> bound{};  ///< minimum and maximum x, then y, then z
    std::vector<float> basis;      ///< [16], empty: linear
    int step = 1;
    std::vector<float> motion;      ///< of its motion block, if it has one
    std::vector<RibCurves> curves;  ///< [times], none where no curve was made
};

/// Throws std::runtime_error where the text is no RIB, or its blocks do not balance.
std::vector<RibChunk> read_rib(const std::string& text);

/// Places on the curves of one time, `steps` of each segment, and radii: x y z r.
std::vector<std::array<float, 4>> places_on(const RibChunk& chunk,
                                            const RibCurves& curves, int steps);

}  // namespace lancret
