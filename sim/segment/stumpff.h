#pragma once
// The Stumpff functions c_m(x) = sum_n (-x)^n / (2n + m)!, smooth everywhere: c0 = cos t,
// c1 = sin t / t, c2 = (1 - cos t) / t^2, c3 = (t - sin t) / t^3 with x = t^2.
//
// c_m = 1/m! - x c_{m+2}, and dc_m/dx = (m c_{m+2} - c_{m+1}) / 2, so that derivatives
// need no division either. T may be a number or a vector of numbers; it needs + - * and
// construction from a double.

#include <array>
#include <cstddef>

namespace lancret {

template <class T>
struct Stumpff {
    T c1, c2, c3, c4, c5;
};

template <class T>
struct StumpffTail {
    T c6, c7;  ///< for second derivatives
};

/// Number of halvings of t, for x = t^2 up to `largest_x`, that make the series exact to
/// round-off.
inline int stumpff_halvings(double largest_x) {
    int halvings = 0;
    for (; largest_x > 1 && halvings < 64; largest_x /= 4) ++halvings;
    return halvings;
}

namespace stumpff {

/// (-1)^n / (2n + m)!
template <int m>
inline constexpr auto kCoefficients = [] {
    std::array<double, 8> out{};
    double factorial = 1;
    for (int i = 2; i <= m; ++i) factorial *= i;
    for (int n = 0; n < 8; ++n) {
        out[std::size_t(n)] = (n % 2 ? -1 : 1) / factorial;
        factorial *= (2 * n + m + 1) * (2 * n + m + 2);
    }
    return out;
}();

/// c_m at x <= 1, m >= 4, by Horner's rule. The first omitted term is below 2^-56 of the
/// sum.
template <int m, class T>
T series(const T& x) {
    T sum(kCoefficients<m>[7]);
    for (int n = 6; n >= 0; --n) sum = sum * x + T(kCoefficients<m>[std::size_t(n)]);
    return sum;
}

/// c1 to c5 from c4 and c5.
template <class T>
Stumpff<T> upwards(const T& x, const T& c4, const T& c5) {
    const T c3 = T(1. / 6) - x * c5, c2 = T(1. / 2) - x * c4;
    return {T(1.0) - x * c3, c2, c3, c4, c5};
}

/// Values at 4x from those at x: double-angle formulas without cancellation.
template <class T>
Stumpff<T> doubled(const T& x, const Stumpff<T>& c) {
    const T c0 = T(1.0) - x * c.c2;
    return {c0 * c.c1, T(0.5) * c.c1 * c.c1, T(0.25) * (c.c3 + c.c1 * c.c2),
            T(0.125) * c.c3 * (T(1.0) + c.c1), T(0.0625) * (c.c5 + c.c4 + c.c2 * c.c3)};
}

template <class T>
StumpffTail<T> doubled(const Stumpff<T>& c, const StumpffTail<T>& tail) {
    return {T(1. / 32) * (T(2.0) * c.c5 + c.c3 * c.c3),
            T(1. / 64) * (tail.c7 + tail.c6 + T(0.5) * c.c5 + c.c3 * c.c4)};
}

template <class T>
T power_of_quarter(int n) {
    T out(1.0);
    for (; n > 0; --n) out = out * T(0.25);
    return out;
}

}  // namespace stumpff

/// c1 to c5 at x >= 0; `halvings` as returned by stumpff_halvings.
template <class T>
Stumpff<T> stumpff_functions(const T& x, int halvings) {
    T reduced = x * stumpff::power_of_quarter<T>(halvings);
    Stumpff<T> c = stumpff::upwards<T>(reduced, stumpff::series<4, T>(reduced),
                                       stumpff::series<5, T>(reduced));
    for (int i = 0; i < halvings; ++i) {
        c = stumpff::doubled<T>(reduced, c);
        reduced = reduced * T(4.0);
    }
    return c;
}

/// The same, and c6 and c7.
template <class T>
Stumpff<T> stumpff_functions(const T& x, int halvings, StumpffTail<T>& tail) {
    T reduced = x * stumpff::power_of_quarter<T>(halvings);
    tail = {stumpff::series<6, T>(reduced), stumpff::series<7, T>(reduced)};
    Stumpff<T> c = stumpff::upwards<T>(reduced, T(1. / 24) - reduced * tail.c6,
                                       T(1. / 120) - reduced * tail.c7);
    for (int i = 0; i < halvings; ++i) {
        const StumpffTail<T> next = stumpff::doubled<T>(c, tail);
        c = stumpff::doubled<T>(reduced, c);
        tail = next;
        reduced = reduced * T(4.0);
    }
    return c;
}

}  // namespace lancret
