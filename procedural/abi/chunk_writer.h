#pragma once
// Expands a chunk into a host's arrays.

#include "procedural/abi/chunk.h"

namespace lancret::abi {

/// Writes the arrays of `out`, whose lengths are those of sizes_of; null arrays are
/// skipped. `workspace` provides temporary memory. Throws InputError, Cancelled,
/// std::bad_alloc.
void write_chunk(const OpenGroom& groom, const ChunkBinding& chunk,
                 const lancret_curves& out, Workspace& workspace);
/// Poses the binding in place instead of a copy.
void write_chunk(const OpenGroom& groom, ChunkBinding&& chunk, const lancret_curves& out,
                 Workspace& workspace);

/// Arrays for everything that was requested, in memory of the workspace, uninitialised.
struct ChunkArrays {
    std::vector<const float*> positions, tangents, normals;  ///< [times]
    lancret_curves curves;                                   ///< points to the arrays

    ChunkArrays(const ChunkBinding& chunk, Workspace& workspace);
    ChunkArrays(const ChunkArrays&) = delete;
    ChunkArrays& operator=(const ChunkArrays&) = delete;
};

}  // namespace lancret::abi
