#include "guides/base/farthest_points.h"

#include <algorithm>
#include <numeric>
#include <queue>

#include "guides/base/point_tree.h"

namespace lancret {

std::vector<std::uint32_t> farthest_points(std::span<const Vec3> points,
                                           std::size_t count, std::uint64_t seed) {
    std::vector<std::uint32_t> chosen;
    if (count >= points.size()) {
        chosen.resize(points.size());
        std::iota(chosen.begin(), chosen.end(), 0u);
        return chosen;
    }
    if (count == 0) return chosen;

    // The next point is the top of a heap of (distance, lower index first). An entry
    // whose distance has shrunk since it was pushed is outdated and skipped. After a
    // choice at distance d only points within d of it can come nearer, and d shrinks from
    // choice to choice.
    struct Entry {
        double squared;
        std::uint32_t index;
        bool operator<(const Entry& other) const {
            return squared != other.squared ? squared < other.squared
                                            : index > other.index;
        }
    };
    const PointTree tree(points);
    std::vector<double> squared(points.size(), std::numeric_limits<double>::infinity());
    std::vector<bool> taken(points.size(), false);
    std::priority_queue<Entry> heap;
    std::vector<std::pair<std::uint32_t, double>> near;
    Entry next{std::numeric_limits<double>::infinity(),
               std::uint32_t(seed % points.size())};
    while (true) {
        chosen.push_back(next.index);
        taken[next.index] = true;
        if (chosen.size() == count) return chosen;
        const auto shrink = [&](std::uint32_t i, double distance) {
            if (taken[i] || !(distance < squared[i])) return;
            squared[i] = distance;
            heap.push({distance, i});
        };
        if (chosen.size() == 1) {
            for (std::uint32_t i = 0; i < points.size(); ++i) {
                shrink(i, (points[i] - points[next.index]).squaredNorm());
            }
        } else {
            // The search finds points strictly within the radius; the distances of those
            // on it do not shrink.
            tree.within(points[next.index], std::sqrt(next.squared), near);
            for (const auto& [i, distance] : near) shrink(i, distance);
        }
        while (taken[heap.top().index] ||
               heap.top().squared != squared[heap.top().index]) {
            heap.pop();
        }
        next = heap.top();
        heap.pop();
    }
}

std::vector<double> neighbour_distances(std::span<const Vec3> points) {
    std::vector<double> out(points.size(), std::numeric_limits<double>::infinity());
    if (points.size() < 2) return out;
    const PointTree tree(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::array<std::uint32_t, 2> index;
        std::array<double, 2> squared;
        tree.nearest(points[i], index, squared);
        // The first of the two is the point itself or coincides with it.
        out[i] = std::sqrt(squared[1]);
    }
    return out;
}

}  // namespace lancret
