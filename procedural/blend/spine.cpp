#include "procedural/blend/spine.h"

namespace lancret {

namespace {

/// Legendre polynomials of degree 0 to 3 at x in [-1, 1].
template <class T>
std::array<T, kSpineTerms> legendre(double x) {
    std::array<double, kSpineTerms> p{1, x};
    for (int j = 2; j < kSpineTerms; ++j) {
        p[j] = ((2 * j - 1) * x * p[j - 1] - (j - 1) * p[j - 2]) / j;
    }
    std::array<T, kSpineTerms> out;
    std::ranges::copy(p, out.begin());
    return out;
}

}  // namespace

template <class T>
SpineBasis<T> spine_basis(int count) {
    SpineBasis<T> out;
    for (int i = 0; i <= count; ++i) {
        out.at_places.push_back(legendre<T>(2.0 * i / count - 1));
    }
    for (int i = 0; i < count; ++i) {
        out.in_middles.push_back(legendre<T>((2.0 * i + 1) / count - 1));
        for (int j = 0; j < kSpineTerms; ++j) out.in_middles[i][j] *= T(2 * j + 1);
    }
    return out;
}

template SpineBasis<float> spine_basis(int);
template SpineBasis<double> spine_basis(int);

}  // namespace lancret
