#pragma once
// Blends: the ways to make a child strand from its guides. One signature, one table.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "procedural/blend/guide_profiles.h"
#include "procedural/curves/control_points.h"

namespace lancret {

/// Maximum number of guides per child.
inline constexpr int kMaxNeighbours = 8;

/// What is blended. A new blend needs a row here, a row in the table in blend.cpp and a
/// source file with its function.
enum class Blend {
    detail,            ///< the guides' spine, the heaviest guide's curvature and torsion
    option1,           ///< curvature, torsion and root frame [TW99, Sec. 4.3, option 1]
    option1_anchored,  ///< option1, turned onto the guides' spine
    option2,           ///< frames along the strand [TW99, Sec. 4.3, option 2]
    option3,           ///< positions from the root frame [TW99, Sec. 4.3, option 3]
    bishop,            ///< bending in rotation-minimising frames
    nearest,           ///< the heaviest guide only: for comparison
    position,  ///< positions from the root, as other generators do: for comparison
};

/// A child before it has a shape.
template <class T>
struct Child {
    std::span<const std::uint32_t> guides;  ///< [k], k <= kMaxNeighbours
    std::span<const T> weights;             ///< [k], >= 0, sum 1
    /// [k] From directions in guide k's root frame to directions in space, turned from
    /// the guide's root to this child's.
    std::span<const Mat3T<T>> to_space;
    T length;  ///< cm
};

/// Shapes the child: `states` has guides.count + 1 places at equal steps of s / L.
/// Positions are relative to the child's root; frames are in space, n0 is the tangent.
template <class T>
using BlendFunction = void (*)(const Child<T>& child, const GuideProfiles<T>& guides,
                               std::span<HelixState<T>> states);

/// Origin of the curvature and torsion of a child's intervals.
enum class BlendRates {
    copied,   ///< from the heaviest guide
    blended,  ///< weighted means over the guides, and a root frame whose N is the bend's
    none,     ///< not formed: the blend works on frames or positions
};

/// Which vector kernel grows a blend's strands; `none`: the blend function does.
enum class BlendKernel { none, curl, position };

/// The properties of a blend that other code depends on.
struct BlendTraits {
    Blend blend;
    std::string_view name;
    BlendFunction<float> in_float;
    BlendFunction<double> in_double;
    BlendRates rates;
    bool anchored;     ///< the strand is turned onto its guides' spine: anchor.h
    bool has_torsion;  ///< frames turn about the tangent as the curl does; otherwise they
                       ///< are carried without twist
    bool keeps_hull;   ///< kappa and tau stay between the smallest and largest of the
                       ///< guides'
    bool mean_places;  ///< places are weighted means of the guides' places in space, not
                       ///< turned to the child's root
    Ends ends;         ///< how a B-spline continues the strand beyond its ends
    BlendKernel kernel;
};

/// All blends, in the order of the enumeration.
std::span<const BlendTraits> blends();

const BlendTraits& traits_of(Blend blend);
std::string_view blend_name(Blend blend);

/// nullopt if no blend has this name.
std::optional<Blend> blend_named(std::string_view name);

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
