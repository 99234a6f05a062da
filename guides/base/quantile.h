#pragma once
// Quantiles of a sample.

#include <vector>

namespace lancret {

/// Two quantiles of a figure over all strands.
struct Spread {
    double median = 0, p95 = 0;
};

/// The value below which a fraction `share` of `values` lies, interpolated linearly
/// between neighbouring values; 0 if there are none.
double quantile(std::vector<double> values, double share);

}  // namespace lancret
