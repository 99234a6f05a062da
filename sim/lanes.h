#pragma once
// Four numbers side by side, for loops over quadrature points. Sums over lanes have one
// order, so every machine gets the same bits whatever the width of its registers.

#include <cstring>

namespace lancret {

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
    void store(double* to) const { std::memcpy(to, &v, sizeof(Vector)); }
    double sum() const { return (v[0] + v[2]) + (v[1] + v[3]); }

    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
    Lanes& operator+=(Lanes b) { return v += b.v, *this; }
};

}  // namespace lancret
