#pragma once
// Four numbers side by side, for loops over quadrature points. Sums over lanes have a
// fixed order, so every machine gets the same bits for any register width.
//
// Code that uses them is compiled once per width (loops_plain.cpp, loops_wide.cpp). Each
// width has its own namespace, so that the linker never mixes up their templates.

#ifndef LANCRET_SIMD
#error "define LANCRET_SIMD, the namespace of a register width, before including this"
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
    /// Stores the first three numbers and leaves the one behind them alone.
    void store3(double* to) const { std::memcpy(to, &v, 3 * sizeof(double)); }
    void store(double* to) const { std::memcpy(to, &v, sizeof(Vector)); }
    double sum() const { return (v[0] + v[2]) + (v[1] + v[3]); }

    /// The sums of the lanes of a, b, c and d, side by side.
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
