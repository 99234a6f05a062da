#pragma once
// One child of a binding: its guides and weights as the kernels and blends read them, and
// its shape as the scalar blends compute it.

#include <cstddef>
#include <cstdint>
#include <span>

#include "procedural/bind/binding.h"
#include "procedural/blend/blend.h"

namespace lancret {

/// A child's guides and weights, without the rotations to its root.
struct LightChild {
    std::uint32_t guides[kMaxNeighbours];  ///< those with a weight above 0
    float weights[kMaxNeighbours];         ///< > 0, sum 1
    std::size_t count = 0;
    std::size_t heaviest = 0;  ///< index of the first with the largest weight
};

LightChild light_child(const Binding& binding, std::size_t i);

/// The arrays of a Child, owned.
template <class T>
struct BoundChild {
    std::uint32_t guides[kMaxNeighbours];
    T weights[kMaxNeighbours];
    Mat3T<T> to_space[kMaxNeighbours];
    std::size_t count = 0;
    T length = 0;

    Child<T> child() const {
        return {{guides, count}, {weights, count}, {to_space, count}, length};
    }
};

/// Child i as a blend reads it. `profiles` may be of any time. The rotation from guide to
/// child is the smallest between the scalp's normals in the binding, which are in the
/// pose of the binding.
template <class T>
BoundChild<T> bound_child(const Binding& binding, const GuideProfiles<T>& profiles,
                          std::size_t i);

/// Synthesises child i with the scalar blend: profiles.count + 1 places at equal steps of
/// arc length, positions relative to its root in cm. The bits are the same on every
/// machine, so decisions that hold for all frames are based on these states. The kernels
/// are tested against them.
template <class T>
void synthesize_child(const Binding& binding, const GuideProfiles<T>& profiles,
                      Blend blend, std::size_t i, std::span<HelixState<T>> states);

}  // namespace lancret
