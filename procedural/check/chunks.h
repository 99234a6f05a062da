#pragma once
// The check of chunks: the boxes that hosts get contain the strands, and the strands of a
// chunk are those of the whole groom.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "procedural/chunk/box.h"
#include "procedural/chunk/chunks.h"

namespace lancret {

struct ChunkCheck {
    std::size_t chunks = 0, strands = 0;
    std::size_t outside = 0;        ///< strands not inside their chunk's chunk_box
    std::size_t outside_reach = 0;  ///< strands not inside its reach_box
    std::size_t unlike = 0;    ///< strands that differ in any bit from the whole groom
    double largest_ratio = 0;  ///< volume of a chunk_box over that of the box of its
                               ///< strands
    double mean_ratio = 0;     ///< the same of volumes summed over the chunks

    bool pass() const { return outside == 0 && outside_reach == 0 && unlike == 0; }
};

/// Checks the chunks of `binding`, whose strands are `curves`; `chunks` hold indices into
/// the binding. Strands are measured with their widths, at the ends of every segment and
/// at three places between.
ChunkCheck check_chunks(const Binding& binding, const ClassedGuides& guides,
                        const Curves& curves, const ExpandSettings& settings,
                        const Chunks& chunks);

/// The number of strands of `curves` that are not inside `box`, cm, measured likewise.
std::size_t strands_outside(const Curves& curves, const Eigen::AlignedBox3f& box);

/// The worse value of every figure, as of two frames.
ChunkCheck worst_of(const ChunkCheck& a, const ChunkCheck& b);

/// A line of text.
std::string chunks_line(const ChunkCheck& check);

/// {count, pass, outside, outside_reach, unlike, volume_over_true.{mean, max}}
nlohmann::json chunks_json(const ChunkCheck& check);

}  // namespace lancret
