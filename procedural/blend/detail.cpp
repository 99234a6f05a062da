// Blend detail: the curvature and torsion of the heaviest guide, in 1/cm at equal s / L,
// anchored to the mean spine of all guides.

#include "procedural/blend/anchor.h"

namespace lancret {

template <class T>
void blend_detail(const Child<T>& child, const GuideProfiles<T>& guides,
                  std::span<HelixState<T>> states) {
    blend_nearest<T>(child, guides, states);
    anchor<T>(child, guides, states);
}

template void blend_detail(const Child<float>&, const GuideProfiles<float>&,
                           std::span<HelixState<float>>);
template void blend_detail(const Child<double>&, const GuideProfiles<double>&,
                           std::span<HelixState<double>>);

}  // namespace lancret
