#pragma once
// Which points of other strands are near.

#include <cstdint>
#include <span>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// A point of another strand.
struct StrandNeighbour {
    std::uint32_t point = 0;  ///< index into the points
    double distance = 0;      ///< cm
};

/// Finds, for each of many points on strands, the nearest point of each other strand: by
/// a hash grid of cells as wide as the radius. Work is in proportion to the points and to
/// how many of them are within two radii of one; buffers stay for the next call, which
/// allocates nothing where there are no more points than before.
class StrandGrid {
  public:
    /// Neighbours that a point has at most: of more strands the nearest are kept.
    static constexpr int kMax = 4;

    /// Finds all neighbours. `strands` says which strand each point is of (any numbers),
    /// and neighbours are within `radius` (cm, > 0) inclusive. Of points at equal
    /// distances the one of the lower index comes first, so the result is the same for
    /// any number of threads. Throws std::invalid_argument where the two spans differ in
    /// size or there are more than 2^30 points, the radius is not above 0, or a point is
    /// not finite.
    void find(std::span<const Vec3> points, std::span<const std::uint32_t> strands,
              double radius);

    /// Of `point`, the nearest first, each of a strand of its own. Valid until the next
    /// find.
    std::span<const StrandNeighbour> neighbours(std::size_t point) const {
        return {&neighbours_[kMax * point], counts_[point]};
    }

  private:
    struct Entry {
        Vec3 position;
        std::uint32_t point, strand;
    };
    void sort_into_buckets(std::span<const Vec3> points,
                           std::span<const std::uint32_t> strands, double cell);
    std::uint32_t search(const Vec3& position, std::uint32_t strand, double radius,
                         StrandNeighbour* out) const;

    double cell_ = 0;                          ///< cm, how wide a cell is
    std::vector<std::uint32_t> keys_;          ///< [points], the bucket of each
    std::vector<std::uint32_t> begins_;        ///< [buckets + 1], of each in entries_
    std::vector<Entry> entries_;               ///< [points], by bucket
    std::vector<StrandNeighbour> neighbours_;  ///< [points * kMax]
    std::vector<std::uint8_t> counts_;         ///< [points]
};

}  // namespace lancret
