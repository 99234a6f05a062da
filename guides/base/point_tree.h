#pragma once
// Nearest neighbours among points. The only file that includes nanoflann.

#include <limits>
#include <nanoflann.hpp>
#include <span>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// A k-d tree over points (cm), which must outlive it. Const calls may come from several
/// threads.
class PointTree {
  public:
    explicit PointTree(std::span<const Vec3> points) : cloud_{points}, tree_(3, cloud_) {}
    PointTree(const PointTree&) = delete;

    /// Fills `indices` and `squared` (distances, cm^2), nearest first; returns the number
    /// found.
    std::size_t nearest(const Vec3& place, std::span<std::uint32_t> indices,
                        std::span<double> squared) const {
        return tree_.knnSearch(place.data(), indices.size(), indices.data(),
                               squared.data());
    }
    /// The squared distance to the nearest point, cm^2; infinity without points.
    double nearest_squared(const Vec3& place) const {
        std::uint32_t index;
        double squared = std::numeric_limits<double>::infinity();
        nearest(place, {&index, 1}, {&squared, 1});
        return squared;
    }
    /// Fills `found` with the points nearer than `radius`: (index, squared distance), not
    /// sorted.
    void within(const Vec3& place, double radius,
                std::vector<std::pair<std::uint32_t, double>>& found) const {
        found.clear();
        nanoflann::SearchParams unsorted;
        unsorted.sorted = false;
        tree_.radiusSearch(place.data(), radius * radius, found, unsorted);
    }

  private:
    struct Cloud {
        std::span<const Vec3> points;
        std::size_t kdtree_get_point_count() const { return points.size(); }
        double kdtree_get_pt(std::size_t i, std::size_t axis) const {
            return points[i][axis];
        }
        template <class Box>
        bool kdtree_get_bbox(Box&) const {
            return false;
        }
    };
    Cloud cloud_;
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>,
                                        Cloud, 3, std::uint32_t>
        tree_;
};

}  // namespace lancret
