#include "sim/contact/strand_contact.h"

#include <oneapi/tbb/parallel_for.h>

#include "sim/segment/gauss_legendre.h"

namespace lancret {

namespace {

/// Calls visit(station, state) for each station of a strand.
template <class Visit>
void for_each_station(HelixState<double> joint, std::span<const double> lengths,
                      std::span<const Vec3> curvatures, int stations, Visit&& visit) {
    const GaussRule rule = gauss_rule(stations);
    for (std::size_t q = 0; q < lengths.size(); ++q) {
        for (int i = 0; i < stations; ++i) {
            HelixState<double> state = joint;
            advance<double>(state, curvatures[q], lengths[q] * rule.nodes[i]);
            visit(q * std::size_t(stations) + std::size_t(i), state);
        }
        advance<double>(joint, curvatures[q], lengths[q]);
    }
}

}  // namespace

void StrandNeighbours::find(const Guides& guides, std::span<const RodPast> pasts,
                            double radius, int stations, double eps) {
    per_guide_ = std::size_t(guides.segments) * std::size_t(stations);
    const std::size_t all = per_guide_ * guides.size();
    positions_.resize(all);
    moves_.resize(all);
    tangents_.resize(all);
    strands_.resize(all);
    near_.resize(all * RodContact::kMaxNear);
    counts_.resize(all);
    tbb::parallel_for(std::size_t(0), guides.size(), [&](std::size_t g) {
        const std::size_t first = g * per_guide_;
        for_each_station(guides.root(g), guides.lengths_of(g), guides.curvatures_of(g),
                         stations, [&](std::size_t i, const auto& state) {
                             positions_[first + i] = state.position;
                             tangents_[first + i] = state.frame.col(0);
                             moves_[first + i].setZero();
                             strands_[first + i] = std::uint32_t(g);
                         });
        if (pasts[g].size == 0) return;
        const RodPose& before = pasts[g].poses[0];
        for_each_station(before.root, guides.lengths_of(g), before.curvatures, stations,
                         [&](std::size_t i, const auto& state) {
                             moves_[first + i] =
                                 (positions_[first + i] - state.position) *
                                 (eps / pasts[g].eps);
                         });
    });
    // Twice the reach, so that cohesion and friction fade out within it.
    grid_.find(positions_, strands_, 4 * radius);
    tbb::parallel_for(std::size_t(0), all, [&](std::size_t station) {
        const auto found = grid_.neighbours(station);
        counts_[station] = std::uint8_t(found.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            const std::size_t other = found[i].point;
            // Each strand of a pair sees the extrapolated position of the other, so each
            // takes half of the energy between them.
            near_[station * RodContact::kMaxNear + i] = {
                positions_[other] + moves_[other], moves_[other], tangents_[other], 0.5};
        }
    });
}

}  // namespace lancret
