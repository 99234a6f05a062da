#pragma once
// A groom whose children are grown chunk by chunk, so that memory does not limit their
// number.

#include "procedural/chunk/box.h"
#include "procedural/chunk/chunks.h"
#include "procedural/groom/children.h"
#include "procedural/groom/ready_groom.h"

namespace lancret {

/// What is kept between chunks: 16 bytes per child on a scalp.
struct ChunkedGroom {
    ReadyGroom ready;   ///< only a sample of the children is bound
    RootPlaces places;  ///< of all children, by id
    Chunks chunks;

    std::size_t bytes() const { return places.bytes() + chunks.bytes(); }
};

/// Loads, chooses and fits the guides, places the children and cuts them into chunks of
/// at most `max_strands` strands. Throws InputError.
ChunkedGroom make_chunked_groom(const GroomSettings& groom,
                                std::uint32_t max_strands = kStrandsPerChunk,
                                const StageCallback& stage = {});

/// The root of a child at rest, cm.
Vec3f place_of(const ChunkedGroom& groom, std::uint32_t child);

/// Binds the children of a chunk, in the order of `classes`; fewer than all if `density`
/// is below 1. The same bits as make_ready_groom. For another time, pose the binding with
/// pose_binding and use the profiles of that time.
Binding bind_chunk(const ChunkedGroom& groom, std::size_t chunk, double density,
                   const StrandClasses& classes);

/// The same at the groom's density, in its classes.
Binding bind_chunk(const ChunkedGroom& groom, std::size_t chunk);

}  // namespace lancret
