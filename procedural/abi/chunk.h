#pragma once
// A chunk: its strands bound to their guides, at rest and posed.

#include <optional>

#include "procedural/abi/request.h"

namespace lancret::abi {

/// Strands of a chunk that have the same number of intervals.
struct ChunkClass {
    std::uint32_t strands, intervals;
    std::uint32_t points;  ///< per strand
};

/// All that a chunk needs to be expanded, apart from its groom.
struct ChunkBinding {
    Request request;
    Binding binding;                  ///< at rest
    std::vector<ChunkClass> classes;  ///< in the order of the strands
};

/// Binds chunk `index`. Throws BadCall, InputError, Cancelled.
ChunkBinding bind_request(const OpenGroom& groom, std::uint32_t index,
                          const lancret_options* options);

/// Expansion settings for one request.
ExpandSettings settings_of(const OpenGroom& groom, const Request& request);

/// The sizes of lancret_curves; all arrays are null. Throws InputError if there are too
/// many points.
lancret_curves sizes_of(const ChunkBinding& chunk);

/// The binding of a chunk, posed for one time after another. `groom` and `chunk` must
/// outlive it.
class PosedBinding {
  public:
    PosedBinding(const OpenGroom& groom, const ChunkBinding& chunk);
    /// Poses the binding of `chunk` in place instead of a copy.
    PosedBinding(const OpenGroom& groom, ChunkBinding&& chunk);
    PosedBinding(const PosedBinding&) = delete;
    PosedBinding& operator=(const PosedBinding&) = delete;
    /// The binding on the posed scalp; valid until the next call.
    const Binding& at(const GuidePose& pose);

  private:
    const Binding& still_;
    RestPlaces rest_;
    std::optional<Binding> copy_;
    Binding* moved_ = nullptr;  ///< null if the groom is static
};

}  // namespace lancret::abi

struct lancret_chunk {
    lancret_context& context;
    std::shared_ptr<const lancret::abi::OpenGroom> groom;
    lancret::abi::ChunkBinding bound;
};
