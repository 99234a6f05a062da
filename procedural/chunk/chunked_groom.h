#pragma once
// A groom whose children are grown a chunk at a time, so that their number is not bounded
// by memory.

#include "procedural/chunk/box.h"
#include "procedural/chunk/chunks.h"
#include "procedural/groom/children.h"
#include "procedural/groom/ready_groom.h"

namespace lancret {

/// What stays between chunks: 16 bytes a child on a scalp.
struct ChunkedGroom {
    ReadyGroom ready;   ///< of which only a sample of the children is bound
    RootPlaces places;  ///< of all children, by id
    Chunks chunks;

    std::size_t bytes() const { return places.bytes() + chunks.bytes(); }
};

/// Loads, chooses and fits guides, says where children stand and cuts them into chunks of
/// at most `most` strands. Throws InputError.
ChunkedGroom make_chunked_groom(const GroomSettings& groom,
                                std::uint32_t most = kStrandsPerChunk,
                                const StageCallback& stage = {});

/// Where a child stands at rest, cm.
Vec3f place_of(const ChunkedGroom& groom, std::uint32_t child);

/// The children of a chunk, bound, in the order of `classes`; of fewer than all where
/// `density` is below 1. Bit for bit those of make_ready_groom. For another time pose it
/// by pose_binding and take the profiles of that time.
Binding bind_chunk(const ChunkedGroom& groom, std::size_t chunk, double density,
                   const StrandClasses& classes);

/// The same at the groom's own density, in its own classes.
Binding bind_chunk(const ChunkedGroom& groom, std::size_t chunk);

/// The strands of a chunk, at rest, at the groom's own density.
Curves expand_chunk(const ChunkedGroom& groom, std::size_t chunk);

/// A box that holds the chunk at rest, known without binding it; see reach_box.
ChunkBox reach_of_chunk(const ChunkedGroom& groom, std::size_t chunk);

}  // namespace lancret
