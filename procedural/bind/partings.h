#pragma once
// Curves on the scalp that no child's guides lie across.

#include <memory>
#include <span>
#include <vector>

#include "guides/base/point_tree.h"
#include "guides/base/types.h"

namespace lancret {

using Polyline = std::vector<Vec3>;  ///< cm

/// The same lines with a point at least every `longest` cm, or every 20,000th of their
/// whole length where that is more.
std::vector<Polyline> divided(std::span<const Polyline> lines, double longest = 0.25);

/// A piece of a parting as seen along a child's normal: from the child's root, in its
/// tangent plane (x, y) and above it (z), cm.
struct SeenPiece {
    Vec3 from, to;
};

/// How wide a guide must be passed, as a share of the nearer of the distances along the
/// line of sight to child and guide, to be seen in full.
inline constexpr double kSightSlope = 0.2;

/// Partings cut into short pieces, with an index, so that what is near a child is found
/// in a time that does not depend on how long the partings are. Const calls are safe from
/// many threads.
class Partings {
  public:
    /// Of `lines`, divided. Throws std::invalid_argument where one has fewer than two
    /// points or one that is not finite.
    explicit Partings(std::span<const Polyline> lines);

    std::size_t size() const { return pieces_.size(); }
    std::span<const std::pair<Vec3, Vec3>> pieces() const { return pieces_; }

    /// The pieces that may come between a child's root at `child` (normal `up`) and
    /// guides within `radius` cm, into `seen`. `scratch` is overwritten.
    void seen_from(const Vec3& child, const Vec3& up, double radius,
                   std::vector<SeenPiece>& seen,
                   std::vector<std::pair<std::uint32_t, double>>& scratch) const;

  private:
    std::vector<std::pair<Vec3, Vec3>> pieces_;
    std::vector<Vec3> middles_;
    double half_longest_ = 0;
    std::unique_ptr<PointTree> tree_;
};

/// `place` as a child with this root and normal sees it: (x, y, z) as in SeenPiece.
Vec3 seen_place(const Vec3& child, const Vec3& up, const Vec3& place);

/// How well a child sees a guide whose root it sees at `guide`, 0 to 1: 0 where the
/// straight line from root to root, both and the parting laid on the child's tangent
/// plane, crosses a piece. It grows from 0 to 1 with how far the line passes clear of
/// every piece: at a place on the line that is t cm from the nearer of the two roots,
/// over a width of kSightSlope t. So it is continuous round the ends and bends of a
/// parting, and jumps only where a root crosses it. What lies above or below the line by
/// more than H / 2 counts less, from H = 0.5 cm + half the line's length on not at all:
/// the parting on the far side of a head does not hide what is on the near side.
double sight(const Vec3& guide, std::span<const SeenPiece> pieces);

}  // namespace lancret
