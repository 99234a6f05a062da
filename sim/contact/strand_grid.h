#pragma once
// A search for nearby points of other strands.

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

/// Finds, for each of many points on strands, the nearest point of each other strand, in
/// a hash grid of cells as wide as the radius. Time is proportional to the number of
/// points times the number of points within two radii of one. Buffers are kept for the
/// next call, which does not allocate unless there are more points than before.
class StrandGrid {
  public:
    /// Maximum number of neighbours per point; the nearest are kept.
    static constexpr int kMax = 4;

    /// Finds all neighbours. `strands` is the strand of each point (any numbers).
    /// Neighbours are within `radius` (cm, > 0), inclusive. Of points at equal distances
    /// the one with the lower index comes first, so the result is the same for any number
    /// of threads. Throws std::invalid_argument if the two spans differ in size, there
    /// are more than 2^30 points, the radius is not above 0, or a point is not finite or
    /// further than 1e10 radii from the origin.
    void find(std::span<const Vec3> points, std::span<const std::uint32_t> strands,
              double radius);

    /// The neighbours of `point`, nearest first, each of a different strand. Valid until
    /// the next find().
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

    double cell_ = 0;                          ///< cm, width of a cell
    std::vector<std::uint32_t> keys_;          ///< [points], their buckets
    std::vector<std::uint32_t> begins_;        ///< [buckets + 1], offsets in entries_
    std::vector<Entry> entries_;               ///< [points], by bucket
    std::vector<StrandNeighbour> neighbours_;  ///< [points * kMax]
    std::vector<std::uint8_t> counts_;         ///< [points]
};

}  // namespace lancret
