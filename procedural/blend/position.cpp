// Blend position, a baseline as used by other generators: the weighted mean of the
// guides' positions relative to the root, in space. The strand is shorter than intended
// where its guides diverge.

#include "procedural/blend/blend.h"

namespace lancret {

template <class T>
void blend_position(const Child<T>& child, const GuideProfiles<T>& guides,
                    std::span<HelixState<T>> states) {
    const std::size_t places = guides.count + 1;
    // The groom may scale children to be longer or shorter than their guides.
    T length = 0;
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        length += child.weights[k] * guides.lengths[child.guides[k]];
    }
    const T scale = child.length / length;
    for (std::size_t i = 0; i < places; ++i) {
        HelixState<T>& state = states[i];
        state.position.setZero();
        Vec3T<T> tangent = Vec3T<T>::Zero();
        for (std::size_t k = 0; k < child.guides.size(); ++k) {
            const std::size_t g = child.guides[k];
            const Mat3T<T> weighted = child.weights[k] * guides.root_frames[g];
            state.position += scale * (weighted * guides.position(g, i));
            tangent += weighted * guides.tangent(g, i);
        }
        // The frame is carried from place to place by the smallest rotation.
        const Mat3T<T> before =
            i == 0 ? guides.root_frames[child.guides[0]] : states[i - 1].frame;
        const T size = tangent.norm();
        tangent = size > T(1e-6) ? Vec3T<T>(tangent / size) : Vec3T<T>(before.col(0));
        state.frame = smallest_rotation<T>(before.col(0), tangent) * before;
        orthonormalize<T>(state.frame);
    }
}

template void blend_position(const Child<float>&, const GuideProfiles<float>&,
                             std::span<HelixState<float>>);
template void blend_position(const Child<double>&, const GuideProfiles<double>&,
                             std::span<HelixState<double>>);

}  // namespace lancret
