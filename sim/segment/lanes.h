#pragma once
// Four numbers side by side, for loops over quadrature points. Sums over lanes have one
// order, so every machine gets the same bits whatever the width of its registers.
//
// Code that uses them is compiled once for each width (segment_loops_*.cpp). Every width
// has its own namespace, so that a template made for one is never taken for the other.

#ifndef LANCRET_SIMD
#error "only a file that says for which registers it is compiled may include this"
#endif

#include <cstring>

namespace lancret::LANCRET_SIMD {

struct Lanes {
    static constexpr int kCount = 4;
    typedef double Vector __attribute__((vector_size(kCount * sizeof(double))));

    Vector v{};

    Lanes() = default;
    explicit Lanes(double x) : v{x, x, x, x} {}
    explicit Lanes(Vector x) : v(x) {}

    static Lanes load(const double* from) {
        Lanes out;
        std::memcpy(&out.v, from, sizeof(Vector));
        return out;
    }
    /// The first three; the fourth is what lies behind.
    void store3(double* to) const { std::memcpy(to, &v, 3 * sizeof(double)); }
    void store(double* to) const { std::memcpy(to, &v, sizeof(Vector)); }
    double sum() const { return (v[0] + v[2]) + (v[1] + v[3]); }

    /// The sums of four, side by side.
    static Lanes sums(Lanes a, Lanes b, Lanes c, Lanes d) {
        const Vector even_ab = __builtin_shufflevector(a.v, b.v, 0, 4, 2, 6);
        const Vector odd_ab = __builtin_shufflevector(a.v, b.v, 1, 5, 3, 7);
        const Vector even_cd = __builtin_shufflevector(c.v, d.v, 0, 4, 2, 6);
        const Vector odd_cd = __builtin_shufflevector(c.v, d.v, 1, 5, 3, 7);
        const Vector r0 = __builtin_shufflevector(even_ab, even_cd, 0, 1, 4, 5);
        const Vector r1 = __builtin_shufflevector(odd_ab, odd_cd, 0, 1, 4, 5);
        const Vector r2 = __builtin_shufflevector(even_ab, even_cd, 2, 3, 6, 7);
        const Vector r3 = __builtin_shufflevector(odd_ab, odd_cd, 2, 3, 6, 7);
        return Lanes((r0 + r2) + (r1 + r3));
    }

    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
    Lanes& operator+=(Lanes b) { return v += b.v, *this; }
};

}  // namespace lancret::LANCRET_SIMD
