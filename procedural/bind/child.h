#pragma once
// One child of a binding: its guides and weights, as kernels and blends read them, and
// its shape by the scalar blends.

#include <cstddef>
#include <cstdint>
#include <span>

#include "procedural/bind/binding.h"
#include "procedural/blend/blend.h"

namespace lancret {

/// A child's guides and weights, without the turns to its root.
struct LightChild {
    std::uint32_t guides[kMaxNeighbours];  ///< those with a weight
    float weights[kMaxNeighbours];         ///< > 0, sum 1
    std::size_t count = 0;
    std::size_t heaviest = 0;  ///< the first of them
};

LightChild light_child(const Binding& binding, std::size_t i);

/// Child i as a blend reads it, with room for what it points to. `profiles` may be of any
/// time; the turn from guide to child is that between the scalp's normals of the pose
/// that the binding is in: that of rest, carried along, where the head moves rigidly.
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

template <class T>
BoundChild<T> bound_child(const Binding& binding, const GuideProfiles<T>& profiles,
                          std::size_t i);

/// Child i by the scalar blends: profiles.count + 1 places at equal steps of arc length,
/// positions relative to its root in cm. The same bits on every machine: whatever is
/// decided once for all frames is decided by these, and the kernels are tested against
/// them.
template <class T>
void synthesize_child(const Binding& binding, const GuideProfiles<T>& profiles,
                      Blend blend, std::size_t i, std::span<HelixState<T>> states);

}  // namespace lancret
