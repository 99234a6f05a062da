#pragma once
// The worse of two errors, with NaN as the worst of all.

#include <cmath>
#include <limits>

namespace lancret {

/// `value`, or infinity if it is NaN.
template <class T>
T nan_as_infinity(T value) {
    return std::isnan(value) ? std::numeric_limits<T>::infinity() : value;
}

/// The larger of two errors; a NaN counts as infinite, so that it is not lost.
template <class T>
T worst_of(T a, T b) {
    if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<T>::infinity();
    return a < b ? b : a;
}

}  // namespace lancret
