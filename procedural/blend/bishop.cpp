// Blend bishop: the weighted sum of the guides' bends in rotation-minimising frames
// [Bishop 1975]. (k1, k2) is a vector and has no singularity on straight parts. The
// guides' frames are aligned at the child's root. Curls of different phase cancel.

#include <algorithm>
#include <cmath>

#include "procedural/blend/blend.h"

namespace lancret {

namespace {

template <class T>
Mat3T<T> root_frame_of(const Child<T>& child) {
    const std::size_t first =
        std::ranges::max_element(child.weights) - child.weights.begin();
    const Mat3T<T>& heaviest = child.to_space[first];
    Vec3T<T> tangent = Vec3T<T>::Zero();
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        tangent += child.weights[k] * child.to_space[k].col(0);
    }
    const T size = tangent.norm();
    if (!(size > T(1e-5))) return heaviest;
    Mat3T<T> out = smallest_rotation<T>(heaviest.col(0), tangent / size) * heaviest;
    orthonormalize<T>(out);
    return out;
}

}  // namespace

template <class T>
void blend_bishop(const Child<T>& child, const GuideProfiles<T>& guides,
                  std::span<HelixState<T>> states) {
    const T ds = child.length / T(guides.count);
    HelixState<T> state{root_frame_of(child), Vec3T<T>::Zero()};
    // A guide's root frame, swung onto the child's tangent, differs from the child's
    // frame by a roll about it.
    Mat3T<T> weighted_roll[kMaxNeighbours];
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        const Mat3T<T> swung =
            smallest_rotation<T>(child.to_space[k].col(0), state.frame.col(0)) *
            child.to_space[k];
        weighted_roll[k] = child.weights[k] * state.frame.transpose() * swung;
    }
    states[0] = state;
    T twist = 0;  // of the frame against the rotation-minimising one
    for (int i = 0; i < guides.count; ++i) {
        Vec3T<T> u = Vec3T<T>::Zero();
        for (std::size_t k = 0; k < child.guides.size(); ++k) {
            u += weighted_roll[k] *
                 guides.bishop[std::size_t(child.guides[k]) * guides.count + i];
        }
        // The curve is a helix in a twisting frame; the child's twists by the mean rate.
        const T middle = twist + u.x() * ds / 2;
        twist += u.x() * ds;
        advance<T>(state, Eigen::AngleAxis<T>(-middle, Vec3T<T>::UnitX()) * u, ds);
        orthonormalize<T>(state.frame);
        states[i + 1] = state;
    }
}

template void blend_bishop(const Child<float>&, const GuideProfiles<float>&,
                           std::span<HelixState<float>>);
template void blend_bishop(const Child<double>&, const GuideProfiles<double>&,
                           std::span<HelixState<double>>);

}  // namespace lancret
