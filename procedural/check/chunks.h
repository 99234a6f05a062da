#pragma once
// The proof of chunks: boxes that hold what they say, strands that are those of the
// whole.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "procedural/chunk/box.h"
#include "procedural/chunk/chunks.h"

namespace lancret {

struct ChunkCheck {
    std::size_t chunks = 0, strands = 0;
    std::size_t outside = 0;  ///< strands that leave the box of their chunk
    std::size_t unlike = 0;  ///< strands that differ, in any bit, from those of the whole
    double largest_ratio = 0;  ///< volume of a chunk's box over that of the box of what
                               ///< is seen there
    double mean_ratio = 0;     ///< volumes summed over the chunks before they are divided

    bool pass() const { return outside == 0 && unlike == 0; }
};

/// Looks at the chunks of `binding`, whose strands as a whole are `curves`. Strands are
/// measured with their widths where t is 0, 1/4, ... on each segment. `chunks` are of
/// places in the binding.
ChunkCheck check_chunks(const Binding& binding, const ClassedGuides& guides,
                        const Curves& curves, const ExpandSettings& settings,
                        const Chunks& chunks);

/// Number of strands that leave `box`, cm, with their widths where t is 0, 1/4, ... on
/// each segment.
std::size_t strands_outside(const Curves& curves, const Eigen::AlignedBox3f& box);

/// The worst of two, as of two frames.
ChunkCheck worst_of(const ChunkCheck& a, const ChunkCheck& b);

/// A line for people.
std::string chunks_line(const ChunkCheck& check);

/// {count, pass, outside, unlike, volume_over_true.{mean, max}}
nlohmann::json chunks_json(const ChunkCheck& check);

}  // namespace lancret
