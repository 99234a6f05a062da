#include "guides/base/quantile.h"

#include <algorithm>
#include <cmath>

namespace lancret {

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    const double at = share * double(values.size() - 1);
    const auto below = values.begin() + std::ptrdiff_t(at);
    std::ranges::nth_element(values, below);
    const double low = *below;
    if (below + 1 == values.end()) return low;
    const double high = *std::min_element(below + 1, values.end());
    return low + (at - std::floor(at)) * (high - low);
}

}  // namespace lancret
