#pragma once
// A chunk from its binding to a host's arrays.

#include <optional>

#include "procedural/abi/request.h"

namespace lancret::abi {

/// Strands of a chunk that are cut alike.
struct ChunkClass {
    std::uint32_t strands, intervals;
    std::uint32_t points;  ///< a strand
};

/// What is kept of a chunk between its sizes and its curves.
struct ChunkBinding {
    Request request;
    Binding binding;                  ///< at rest
    std::vector<ChunkClass> classes;  ///< of all strands, in their order
};

/// Throws BadCall, InputError.
ChunkBinding bind_request(const OpenGroom& groom, std::uint32_t chunk,
                          const lancret_options* options);

/// What expansion is told.
ExpandSettings settings_of(const OpenGroom& groom, const Request& request);

/// A chunk's binding at one pose after another. Both it was made of must outlive it.
class PosedBinding {
  public:
    PosedBinding(const OpenGroom& groom, const ChunkBinding& bound);
    /// Moves that binding itself, of which nothing is copied.
    PosedBinding(const OpenGroom& groom, ChunkBinding&& bound);
    PosedBinding(const PosedBinding&) = delete;
    PosedBinding& operator=(const PosedBinding&) = delete;
    /// The binding where the scalp is at that pose, until the next is asked for.
    const Binding& at(const GuidePose& pose);

  private:
    const Binding& still_;
    RestPlaces rest_;
    std::optional<Binding> copy_;
    Binding* moved_ = nullptr;  ///< where the groom moves
};

/// All of lancret_curves but its pointers.
lancret_curves sizes_of(const ChunkBinding& bound);

/// Writes the arrays that `out` points to, all but those that are null; all of them are
/// as long as sizes_of says. `workspace` lends memory for what is not kept. A chunk that
/// is no more of use is not copied to be moved.
void write_chunk(const OpenGroom& groom, const ChunkBinding& bound,
                 const lancret_curves& out, Workspace& workspace);
void write_chunk(const OpenGroom& groom, ChunkBinding&& bound, const lancret_curves& out,
                 Workspace& workspace);

/// Arrays for all that was asked for, in memory of the workspace.
struct ChunkArrays {
    std::vector<const float*> positions, tangents, normals;  ///< [times]
    lancret_curves curves;                                   ///< points into these

    ChunkArrays(const ChunkBinding& bound, Workspace& workspace);
    ChunkArrays(const ChunkArrays&) = delete;
    ChunkArrays& operator=(const ChunkArrays&) = delete;
};

}  // namespace lancret::abi

struct lancret_chunk {
    lancret_context& context;
    std::shared_ptr<const lancret::abi::OpenGroom> groom;
    lancret::abi::ChunkBinding own;
};
