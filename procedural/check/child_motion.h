#pragma once
// Whether children move as their guides do: how far the places of a child move between
// two times, compared with those of its guides.

#include <algorithm>
#include <optional>
#include <span>

#include "guides/base/rigid_pose.h"
#include "procedural/expand/expand.h"

namespace lancret {

/// Lower limit that guides' motion is raised to, cm: a twentieth of a hair's width. A
/// child that jumps while its guides rest still stands out.
inline constexpr double kMinMotion = 5e-4;

/// The children at one time: the binding posed at that time, and the profiles of that
/// time. `carriers` are the rigid motions of the children's roots, which are factored
/// out: [children], or one for all.
struct Moment {
    const Binding* binding = nullptr;
    const GuideProfiles<double>* profiles = nullptr;
    std::span<const RigidPose> carriers;
};

/// The motion of a child between two times, relative to its carrier.
struct ChildMotion {
    double child = 0;   ///< cm, the largest motion of a place at constant s / L
    double guides = 0;  ///< cm, the same of its guides, as if each stood on the child's
                        ///< root and were scaled to its length
    std::optional<double> limit;  ///< cm, upper limit of `child` that follows from the
                                  ///< guides' motion; nullopt if the blend has none
    /// child / guides, with guides' motion raised to kMinMotion.
    double amplification() const { return child / std::max(guides, kMinMotion); }
    /// child / limit, with the limit raised to kMinMotion; 0 without one.
    double share_of_limit() const {
        return limit ? child / std::max(*limit, kMinMotion) : 0;
    }
};

/// The motion of child i from `a` to `b`, two moments of one binding. If the blend works
/// on directions, which binding turns from the guide's root to the child's, its guides
/// are turned too. Throws std::invalid_argument.
ChildMotion child_motion(const Moment& a, const Moment& b, Blend blend, std::size_t i);

/// The largest values over all children.
struct MotionReport {
    double amplification = 0;
    std::uint32_t child = 0;    ///< id of the first child with that amplification
    ChildMotion motion;         ///< of that child
    double share_of_limit = 0;  ///< above 1 a child jumps
    double largest_child = 0;   ///< cm, of all children
    double largest_guides = 0;  ///< cm, of all children's guides
};

/// Measures every child from `a` to `b`, in parallel; the same for any number of threads.
/// Throws std::invalid_argument.
MotionReport check_motion(const Moment& a, const Moment& b, Blend blend);

/// Upper limit of a blend's amplification for any motion of the guides; nullopt if there
/// is none. Derived in docs/time.md.
std::optional<double> amplification_limit(Blend blend);

}  // namespace lancret
