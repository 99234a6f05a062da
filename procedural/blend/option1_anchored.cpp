// Blend option1-anchored: the strand of option1, anchored to its guides' spine, so that
// integrating its curvature and torsion no longer makes it drift.

#include "procedural/blend/anchor.h"

namespace lancret {

template <class T>
void blend_option1_anchored(const Child<T>& child, const GuideProfiles<T>& guides,
                            std::span<HelixState<T>> states) {
    blend_option1<T>(child, guides, states);
    anchor<T>(child, guides, states);
}

template void blend_option1_anchored(const Child<float>&, const GuideProfiles<float>&,
                                     std::span<HelixState<float>>);
template void blend_option1_anchored(const Child<double>&, const GuideProfiles<double>&,
                                     std::span<HelixState<double>>);

}  // namespace lancret
