// Blend option3: the operators R_k(s) that carry the root frame to a place [TW99,
// Sec. 4.3, option 3]. R_k(s) applied to the root frame is the place relative to the
// root, so this blends positions, turned from guide to child. As the paper advises, the
// resulting length is measured and the whole strand rescaled to the intended length. Arc
// length remains unevenly distributed along the strand.

#include <cmath>

#include "procedural/blend/blend.h"

namespace lancret {

namespace {

/// The length of the circular arc over `chord` with unit tangents `from` and `to` at its
/// ends.
template <class T>
T arc_length(const Vec3T<T>& chord, const Vec3T<T>& from, const Vec3T<T>& to) {
    const T half_sine = std::min<T>((to - from).norm() / 2, 1);
    if (half_sine < T(1e-3)) return chord.norm();
    return chord.norm() * std::asin(half_sine) / half_sine;
}

}  // namespace

template <class T>
void blend_option3(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states) {
    T length = 0;
    for (int i = 0; i <= guides.count; ++i) {
        HelixState<T>& state = states[i];
        state.position.setZero();
        Vec3T<T> tangent = Vec3T<T>::Zero();
        for (std::size_t k = 0; k < child.guides.size(); ++k) {
            const std::size_t g = child.guides[k];
            const Mat3T<T> weighted = child.weights[k] * child.to_space[k];
            state.position += weighted * guides.position(g, i);
            tangent += guides.lengths[g] * (weighted * guides.tangent(g, i));
        }
        const Mat3T<T> before = i == 0 ? child.to_space[0] : states[i - 1].frame;
        const T size = tangent.norm();
        tangent = size > T(1e-6) ? Vec3T<T>(tangent / size) : Vec3T<T>(before.col(0));
        state.frame = smallest_rotation<T>(before.col(0), tangent) * before;
        orthonormalize<T>(state.frame);
        if (i > 0) {
            length += arc_length<T>(state.position - states[i - 1].position,
                                    states[i - 1].frame.col(0), tangent);
        }
    }
    if (!(length > 0)) return;
    for (HelixState<T>& state : states) state.position *= child.length / length;
}

template void blend_option3(const Child<float>&, const GuideProfiles<float>&,
                            std::span<HelixState<float>>);
template void blend_option3(const Child<double>&, const GuideProfiles<double>&,
                            std::span<HelixState<double>>);

}  // namespace lancret
