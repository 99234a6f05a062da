#include "guides/helix/guides.h"

#include <numeric>

namespace lancret {

double guide_length(const Guides& guides, std::size_t g) {
    const auto lengths = guides.lengths_of(g);
    return std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

}  // namespace lancret
