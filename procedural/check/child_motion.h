#pragma once
// Whether children move as their guides do: how far a child's places go between two
// times, beside how far those of its guides go.

#include <algorithm>
#include <optional>
#include <span>

#include "guides/base/rigid_pose.h"
#include "procedural/expand/expand.h"

namespace lancret {

/// Guides' motion below this counts as this much, cm: a twentieth of a hair's width. A
/// child that jumps while its guides rest still shows.
inline constexpr double kMinMotion = 5e-4;

/// The children at one time. The binding is posed there; the profiles are of that time.
/// `carriers` take out how each child's root is carried along and turned: [children], or
/// one for all of them.
struct Moment {
    const Binding* binding = nullptr;
    const GuideProfiles<double>* profiles = nullptr;
    std::span<const RigidPose> carriers;
};

/// What a child does between two times, seen from its root and turned along with it.
struct ChildMotion {
    double child = 0;   ///< the farthest that a place s / L of it goes, cm
    double guides = 0;  ///< the farthest that a place of any of its guides goes, cm, as
                        ///< if that guide stood on the child's root, lengthened or
                        ///< shortened as the child is
    std::optional<double> bound;  ///< cm, that `child` may not go beyond, from what the
                                  ///< guides do, where the blend has one
    /// child / guides, guides' motion being at least kMinMotion.
    double amplification() const { return child / std::max(guides, kMinMotion); }
    /// child / bound, the bound being at least kMinMotion; 0 without one.
    double share_of_limit() const {
        return bound ? child / std::max(*bound, kMinMotion) : 0;
    }
};

/// Of child i; `a` and `b` are of one binding. Where the blend works in directions that
/// binding turns from the guide's root to the child's, so are its guides'.
ChildMotion child_motion(const Moment& a, const Moment& b, Blend blend, std::size_t i);

/// The most of all children: each figure's largest value, and whose it is.
struct TemporalReport {
    double amplification = 0;
    std::uint32_t child = 0;    ///< whose that is, the first such
    ChildMotion motion;         ///< of that child
    double share_of_limit = 0;  ///< the largest of all children's; above 1 one jumps
    double largest_child = 0;   ///< cm, of all children
    double largest_guides = 0;  ///< cm, of all children's guides
};

/// Looks at every child on all threads; the same for any number of them.
TemporalReport temporal_check(const Moment& a, const Moment& b, Blend blend);

/// What a blend's amplification cannot go beyond, whatever its guides do; nothing where
/// there is no such number. docs/time.md derives it.
std::optional<double> amplification_bound(Blend blend);

}  // namespace lancret
