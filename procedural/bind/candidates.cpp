#include "procedural/bind/candidates.h"

#include <algorithm>
#include <cmath>

#include "procedural/bind/weights.h"

namespace lancret {

namespace {

/// 1 if the normals are within half the maximum angle of each other, falling smoothly to
/// 0 at the maximum.
double angle_share(const Vec3& up, const Vec3f& guide_up, double max_angle) {
    if (!std::isfinite(max_angle)) return 1;
    const Vec3 other = guide_up.cast<double>();
    const double angle = std::atan2(up.cross(other).norm(), up.dot(other));
    const double t = std::clamp(2 - 2 * angle / max_angle, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace

std::optional<std::size_t> Candidates::first_in_sight() const {
    for (std::size_t j = 0; j < size; ++j) {
        if (sights[j] > 0) return j;
    }
    return std::nullopt;
}

/// Sets sights and shares; returns the sum of the shares.
double CandidateFinder::set_shares(const Vec3& place, const Vec3& up) {
    seen_.clear();
    if (partings_ && out_.size > 0) {
        partings_->seen_from(place, up, out_.distances[out_.size - 1], seen_, scratch_);
    }
    double sum = 0;
    for (std::size_t j = 0; j < out_.size; ++j) {
        const std::uint32_t g = out_.guides[j];
        double& seen = out_.sights[j];
        seen = seen_.empty()
                   ? 1
                   : sight(seen_place(place, up, guides_.root_positions[g]), seen_);
        const bool near = out_.distances[j] < settings_.max_distance;
        out_.shares[j] = near && seen > 0
                             ? seen * angle_share(up, normals_[g], settings_.max_angle)
                             : 0;
        sum += out_.shares[j];
    }
    return sum;
}

const Candidates& CandidateFinder::find(const Vec3& place, const Vec3& up,
                                        std::uint32_t region, std::size_t k) {
    const GuideIndex::Group* group = index_.of(region);
    out_.from_all_regions = group == nullptr;
    if (!group) group = &index_.all();
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::size_t wanted = k + 1;
    double sum = 0, last = kFar;
    while (true) {
        out_.size = group->tree->nearest(place, {out_.guides.data(), wanted},
                                         {squared_.data(), wanted});
        for (std::size_t j = 0; j < out_.size; ++j) {
            out_.distances[j] = std::sqrt(squared_[j]);
            if (!group->guides.empty()) out_.guides[j] = group->guides[out_.guides[j]];
        }
        sum = set_shares(place, up);
        const bool all = out_.size < wanted;
        last = all ? kFar : out_.distances[out_.size - 1];
        // Exact if all shares are 1: those are sums of whole numbers.
        const bool far_enough =
            last >= settings_.max_distance && out_.first_in_sight().has_value();
        if (all || sum >= double(k + 1) || far_enough || wanted == kMaxCandidates) {
            break;
        }
        wanted = std::min(4 * wanted, kMaxCandidates);
    }
    last = std::min(last, settings_.max_distance);
    if (sum == double(out_.size)) {  // all shares are 1: the nearest k
        out_.reach = out_.size > k ? std::min(out_.distances[k], last) : last;
        out_.within = std::min(k, out_.size);
    } else {
        out_.reach = neighbour_reach({out_.distances.data(), out_.size},
                                     {out_.shares.data(), out_.size}, k, last);
        const auto end = out_.distances.begin() + std::ptrdiff_t(out_.size);
        const auto beyond =
            std::upper_bound(out_.distances.begin(), end, out_.reach * (1 + 1e-9));
        out_.within = std::size_t(beyond - out_.distances.begin());
    }
    return out_;
}

}  // namespace lancret
