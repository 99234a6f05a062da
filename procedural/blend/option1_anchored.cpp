// Option 1's strand, anchored to where the guides run: what its curvature and torsion sum
// up to no longer drifts.

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
