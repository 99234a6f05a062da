#pragma once
// Growing a groom chunk by chunk.

#include <cstdint>
#include <string>

#include "tools/frames.h"
#include "tools/job.h"

namespace lancret {

/// lancret expand --chunks: grows the children of a job in chunks of at most
/// `chunk_strands`, discards them and prints the cost. Throws InputError.
void expand_by_chunks(const Job& job, const FrameOptions& frame,
                      std::uint32_t chunk_strands, const std::string& stats_file);

}  // namespace lancret
