#pragma once
// Reads the subset of RIB that RibHost writes.

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

/// Everything between AttributeBegin and AttributeEnd of one procedural.
struct RibChunk {
    std::array<float, 6> bound{};  ///< minimum and maximum x, then y, then z
    std::vector<float> basis;      ///< [16], empty: linear
    int step = 1;
    std::vector<float> motion;      ///< times of its motion block; empty without one
    std::vector<RibCurves> curves;  ///< [times]; empty if no curve was emitted
};

/// Throws std::runtime_error if the text is not RIB or its blocks are unbalanced.
std::vector<RibChunk> read_rib(const std::string& text);

/// Positions on the curves of one time, `steps` + 1 per segment, and radii: x y z r.
std::vector<std::array<float, 4>> places_on(const RibChunk& chunk,
                                            const RibCurves& curves, int steps);

}  // namespace lancret
