#pragma once
// How a child strand is made from its guides: one signature, one table of names.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "procedural/blend/guide_profiles.h"

namespace lancret {

/// The most guides that a child can have.
inline constexpr int kMaxNeighbours = 8;

/// What is blended; each has its own blend_*.cpp.
enum class Blend {
    detail,            ///< the guides' spine, the dominant guide's curvature and torsion
    option1,           ///< curvature, torsion and root frame [TW99, Sec. 4.3, option 1]
    option1_anchored,  ///< the same, turned onto the guides' spine
    option2,           ///< frames along the strand [TW99, Sec. 4.3, option 2]
    option3,           ///< places from the root frame [TW99, Sec. 4.3, option 3]
    bishop,            ///< bending in rotation-minimising frames
    nearest,           ///< the dominant guide alone: for comparison
    position,  ///< positions from the root, as other generators do: for comparison
};

struct BlendName {
    Blend blend;
    std::string_view name;
};
inline constexpr BlendName kBlendNames[] = {{Blend::detail, "detail"},
                                            {Blend::option1, "option1"},
                                            {Blend::option1_anchored, "option1-anchored"},
                                            {Blend::option2, "option2"},
                                            {Blend::option3, "option3"},
                                            {Blend::bishop, "bishop"},
                                            {Blend::nearest, "nearest"},
                                            {Blend::position, "position"}};

std::string_view blend_name(Blend blend);
std::optional<Blend> blend_named(std::string_view name);

/// Whether frames of this blend turn about the tangent as the curl does; else they are
/// carried without twist and know no torsion.
bool has_torsion(Blend blend);

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
void blend_detail(const Child<T>& child, const GuideProfiles<T>& guides,
                  std::span<HelixState<T>> states);
template <class T>
void blend_option1(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states);
template <class T>
void blend_option1_anchored(const Child<T>& child, const GuideProfiles<T>& guides,
                            std::span<HelixState<T>> states);
template <class T>
void blend_option2(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states);
template <class T>
void blend_option3(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states);
template <class T>
void blend_bishop(const Child<T>& child, const GuideProfiles<T>& guides,
                  std::span<HelixState<T>> states);
template <class T>
void blend_nearest(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states);
template <class T>
void blend_position(const Child<T>& child, const GuideProfiles<T>& guides,
                    std::span<HelixState<T>> states);

}  // namespace lancret
