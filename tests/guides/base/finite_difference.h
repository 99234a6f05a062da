#pragma once

namespace lancret {

/// df/dx by central differences of steps h and h/2, extrapolated: the error is of order
/// h^4 f'''''/480 in truncation and 3 epsilon |f| / h in round-off.
template <class F>
auto finite_difference(F&& f, double x, double h) {
    const auto central = [&](double s) {
        return ((f(x + s) - f(x - s)) / (2 * s)).eval();
    };
    return ((4 * central(h / 2) - central(h)) / 3).eval();
}

}  // namespace lancret
