#include "sim/contact/strand_grid.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "guides/base/errors.h"
#include "guides/base/hash.h"

namespace lancret {

namespace {

constexpr std::size_t kMaxPoints = std::size_t(1) << 30;
constexpr std::size_t kChunk = 1024;

/// Width of a cell in radii. It is slightly above 1 because the cell coordinate of a
/// position, up to 1e10, has an error of at most 1.2e-6: positions within a radius of
/// each other are then always in adjacent cells.
constexpr double kMaxRadii = 1e10, kCellWidth = 1 + 1e-5;

/// The cell of a position: whole numbers as doubles, since they may exceed the range of
/// int.
Vec3 cell_of(const Vec3& position, double cell) {
    return (position / cell).array().floor().matrix();
}

/// The hash of a cell. Cells may share a hash; a search then sees points that are too far
/// away, or some points twice, and neither changes the result.
std::uint64_t cell_hash(const Vec3& cell) {
    // + 0.0: -0 becomes 0.
    return hash_bits(std::bit_cast<std::uint64_t>(cell.x() + 0.0),
                     std::bit_cast<std::uint64_t>(cell.y() + 0.0),
                     std::bit_cast<std::uint64_t>(cell.z() + 0.0));
}

}  // namespace

void StrandGrid::find(std::span<const Vec3> points,
                      std::span<const std::uint32_t> strands, double radius) {
    require(points.size() == strands.size() && points.size() <= kMaxPoints,
            "StrandGrid: expected one strand per point and at most 2^30 points");
    require(radius > 0 && std::isfinite(radius),
            "StrandGrid: the radius must be above 0");
    // Written so that a NaN fails.
    require(std::ranges::all_of(points,
                                [&](const Vec3& p) {
                                    return p.allFinite() &&
                                           p.cwiseAbs().maxCoeff() <= kMaxRadii * radius;
                                }),
            "StrandGrid: points must be within 1e10 radii of the origin");
    sort_into_buckets(points, strands, kCellWidth * radius);
    neighbours_.resize(kMax * points.size());
    counts_.resize(points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), kChunk),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i) {
                              counts_[i] = std::uint8_t(search(
                                  points[i], strands[i], radius, &neighbours_[kMax * i]));
                          }
                      });
}

void StrandGrid::sort_into_buckets(std::span<const Vec3> points,
                                   std::span<const std::uint32_t> strands, double cell) {
    const std::size_t buckets = std::bit_ceil(2 * points.size() + 1);
    keys_.resize(points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), kChunk),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i) {
                              keys_[i] = std::uint32_t(
                                  cell_hash(cell_of(points[i], cell)) & (buckets - 1));
                          }
                      });
    // A counting sort: counts become the end of each bucket; inserting the points in
    // reverse order then moves it to the begin of the bucket.
    begins_.assign(buckets + 1, 0);
    for (const std::uint32_t key : keys_) ++begins_[key];
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : begins_) begin = sum += begin;
    entries_.resize(points.size());
    for (std::size_t i = points.size(); i-- > 0;) {
        entries_[--begins_[keys_[i]]] = {points[i], std::uint32_t(i), strands[i]};
    }
    cell_ = cell;
}

std::uint32_t StrandGrid::search(const Vec3& position, std::uint32_t strand,
                                 double radius, StrandNeighbour* out) const {
    // The nearest points so far, at most one per strand, ordered by squared distance and
    // index.
    struct Candidate {
        double distance2;
        std::uint32_t point, strand;

        bool operator<(const Candidate& other) const {
            return distance2 != other.distance2 ? distance2 < other.distance2
                                                : point < other.point;
        }
    };
    std::array<Candidate, kMax> best{};
    int count = 0;
    const auto offer = [&](const Candidate& candidate) {
        // Its rank, unless a nearer point of its strand is in the list.
        int rank = 0;
        while (rank < count && best[rank] < candidate) {
            if (best[rank].strand == candidate.strand) return;
            ++rank;
        }
        if (rank == kMax) return;
        // It replaces the further point of its strand, or else the furthest of all.
        int replaced = rank;
        while (replaced < count && best[replaced].strand != candidate.strand) ++replaced;
        if (replaced == count && count < kMax) ++count;
        replaced = std::min(replaced, kMax - 1);
        std::copy_backward(best.begin() + rank, best.begin() + replaced,
                           best.begin() + replaced + 1);
        best[rank] = candidate;
    };

    const Vec3 home = cell_of(position, cell_);
    const std::uint64_t mask = begins_.size() - 2;
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
        const Vec3 cell =
            home + Vec3(neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1);
        const std::size_t bucket = cell_hash(cell) & mask;
        for (std::uint32_t e = begins_[bucket]; e < begins_[bucket + 1]; ++e) {
            const Entry& entry = entries_[e];
            const double distance2 = (entry.position - position).squaredNorm();
            if (entry.strand == strand || !(distance2 <= radius * radius)) continue;
            offer({distance2, entry.point, entry.strand});
        }
    }
    for (int i = 0; i < count; ++i) {
        out[i] = {best[i].point, std::sqrt(best[i].distance2)};
    }
    return std::uint32_t(count);
}

}  // namespace lancret
