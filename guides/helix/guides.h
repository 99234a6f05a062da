#pragma once
// Guides: the strands that are simulated, each a root frame and a chain of helices.

#include <span>
#include <vector>

#include "guides/helix/helix.h"

namespace lancret {

/// Super-Helices with the same number of segments [Bergbom07, Sec. 4.1]. The segments of
/// guide g are [g * segments, (g + 1) * segments).
struct Guides {
    int segments = 0;                     ///< per guide
    std::vector<Vec3> root_positions;     ///< [size], cm
    std::vector<Mat3> root_frames;        ///< [size], columns n0 (tangent), n1, n2
    std::vector<double> segment_lengths;  ///< [size * segments], cm, > 0
    std::vector<Vec3> curvatures;         ///< [size * segments], (k0, k1, k2), 1/cm

    std::size_t size() const { return root_positions.size(); }
    std::span<const double> lengths_of(std::size_t g) const {
        return std::span(segment_lengths).subspan(g * segments, segments);
    }
    std::span<const Vec3> curvatures_of(std::size_t g) const {
        return std::span(curvatures).subspan(g * segments, segments);
    }
    HelixState<double> root(std::size_t g) const {
        return {root_frames[g], root_positions[g]};
    }
};

/// The length of guide g, cm.
double guide_length(const Guides& guides, std::size_t g);

}  // namespace lancret
