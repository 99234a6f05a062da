// Blend nearest, a baseline: the curvature and torsion of the heaviest guide, at the
// child's blended length. The curl is that of a real strand; the position is not blended.

#include <algorithm>

#include "procedural/blend/blend.h"

namespace lancret {

template <class T>
void blend_nearest(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states) {
    const std::size_t first =
        std::ranges::max_element(child.weights) - child.weights.begin();
    const std::size_t g = child.guides[first];
    const T ds = child.length / T(guides.count);
    HelixState<T> state{child.to_space[first], Vec3T<T>::Zero()};
    orthonormalize<T>(state.frame);
    states[0] = state;
    for (int i = 0; i < guides.count; ++i) {
        advance<T>(state, guides.curvatures[g * guides.count + i], ds);
        orthonormalize<T>(state.frame);
        states[i + 1] = state;
    }
}

template void blend_nearest(const Child<float>&, const GuideProfiles<float>&,
                            std::span<HelixState<float>>);
template void blend_nearest(const Child<double>&, const GuideProfiles<double>&,
                            std::span<HelixState<double>>);

}  // namespace lancret
