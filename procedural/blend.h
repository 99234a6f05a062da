#pragma once
// How a child strand is made from its guides: one signature, one table of names.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "procedural/guide_profiles.h"

namespace lancret {

/// The most guides that a child can have.
inline constexpr int kMaxNeighbours = 8;

/// What is blended; each has its own blend_*.cpp.
enum class Blend {
    option1,   ///< curvature, torsion and root frame [TW99, Sec. 4.3, option 1]
    position,  ///< positions from the root, as other generators do: for comparison
};

struct BlendName {
    Blend blend;
    std::string_view name;
};
inline constexpr BlendName kBlendNames[] = {{Blend::option1, "option1"},
                                            {Blend::position, "position"}};

std::string_view blend_name(Blend blend);
std::optional<Blend> blend_named(std::string_view name);

/// A child before it has a shape.
template <class T>
struct Child {
    std::span<const std::uint32_t> guides;  ///< [k], k <= kMaxNeighbours
    std::span<const T> weights;             ///< [k], >= 0, sum 1
    /// [k] directions of guide k's root frame to directions in space, turned from the
    /// guide's root to this child's.
    std::span<const Mat3T<T>> to_space;
    T length;  ///< cm
};

/// Shapes the child: `states` has guides.count + 1 places at equal steps of s / L.
/// Positions are from the child's root, frames are in space with n0 the tangent.
template <class T>
using BlendFunction = void (*)(const Child<T>& child, const GuideProfiles<T>& guides,
                               std::span<HelixState<T>> states);

template <class T>
BlendFunction<T> blend_function(Blend blend);

template <class T>
void blend_option1(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states);
template <class T>
void blend_position(const Child<T>& child, const GuideProfiles<T>& guides,
                    std::span<HelixState<T>> states);

}  // namespace lancret
