#pragma once
// Partings: curves on the scalp that separate children from the guides beyond them.

#include <memory>
#include <span>
#include <vector>

#include "guides/base/point_tree.h"
#include "guides/base/types.h"

namespace lancret {

using Polyline = std::vector<Vec3>;  ///< cm

/// The same lines with a point at least every `longest` cm, or at least every 20,000th of
/// their total length if that is more.
std::vector<Polyline> divided(std::span<const Polyline> lines, double longest = 0.25);

/// A piece of a parting relative to a child's root, cm: x and y in the child's tangent
/// plane, z along its normal.
struct SeenPiece {
    Vec3 from, to;
};

/// Distance between the line of sight and a parting at which the guide is fully visible,
/// divided by the distance along the line to the nearer of child and guide.
inline constexpr double kSightSlope = 0.2;

/// Partings cut into short pieces with a search tree, so that the time to find those near
/// a child does not depend on the length of the partings. Const calls are thread-safe.
class Partings {
  public:
    /// Divides `lines`. Throws std::invalid_argument if a line has fewer than two points
    /// or a point that is not finite.
    explicit Partings(std::span<const Polyline> lines);

    std::size_t size() const { return pieces_.size(); }
    std::span<const std::pair<Vec3, Vec3>> pieces() const { return pieces_; }

    /// Writes to `seen` the pieces that may hide guides within `radius` cm from a child
    /// with root `child` and normal `up`. `scratch` is overwritten.
    void seen_from(const Vec3& child, const Vec3& up, double radius,
                   std::vector<SeenPiece>& seen,
                   std::vector<std::pair<std::uint32_t, double>>& scratch) const;

  private:
    std::vector<std::pair<Vec3, Vec3>> pieces_;
    std::vector<Vec3> middles_;
    double half_longest_ = 0;
    std::unique_ptr<PointTree> tree_;
};

/// `place` in the coordinates of SeenPiece, for a child with this root and normal.
Vec3 seen_place(const Vec3& child, const Vec3& up, const Vec3& place);

/// Visibility, 0 to 1, of a guide with its root at `guide` (in the coordinates of
/// SeenPiece). It is 0 if the straight line from the child's root to the guide's,
/// projected onto the child's tangent plane, crosses a piece. It rises to 1 with the
/// distance between the line and every piece: at a point of the line t cm from the nearer
/// root, over a width of kSightSlope t. So visibility is continuous around the ends and
/// bends of a parting and jumps only if a root crosses it.
///
/// A piece above or below the line has its full effect up to H / 2 and none from H on,
/// H = 0.5 cm + half the line's length: a parting on the far side of a head does not hide
/// guides on the near side.
double sight(const Vec3& guide, std::span<const SeenPiece> pieces);

}  // namespace lancret
