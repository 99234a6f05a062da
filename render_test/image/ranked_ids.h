#pragma once
// The ids that cover most of a pixel, in a fixed number of bytes.

#include <algorithm>
#include <array>
#include <cstdint>

namespace lancret {

/// The heaviest in a stream of ids [Metwally et al. 2005, "Efficient computation of
/// frequent and top-k elements": Space-Saving]. It contains every id with more than
/// 1 / kSlots of the total weight. The weight that an id certainly has is stored apart
/// from what it inherited from ids that it replaced, so no weight is overestimated; up to
/// kSlots different ids are exact.
struct RankedIds {
    static constexpr int kSlots = 12;

    std::array<std::uint32_t, kSlots> ids{};
    std::array<float, kSlots> bounds{};   ///< upper bounds, unsorted; 0: free
    std::array<float, kSlots> certain{};  ///< lower bounds

    void add(std::uint32_t id, float weight) {
        if (!(weight > 0)) return;
        int slot = 0, lightest = 0;
        for (; slot < kSlots && bounds[slot] > 0 && ids[slot] != id; ++slot) {
            if (bounds[slot] < bounds[lightest]) lightest = slot;
        }
        if (slot == kSlots) {
            slot = lightest;
            certain[slot] = 0;
        }
        ids[slot] = id;
        bounds[slot] += weight;
        certain[slot] += weight;
    }

    struct Rank {
        std::uint32_t id = 0;
        float weight = 0;  ///< certain; 0: no such rank
    };
    /// The heaviest first; ties by the smaller id.
    template <int kRanks>
    std::array<Rank, kRanks> ranks() const {
        static_assert(kRanks <= kSlots);
        std::array<Rank, kSlots> all;
        for (int i = 0; i < kSlots; ++i) all[i] = {ids[i], certain[i]};
        std::ranges::sort(all, [](const Rank& a, const Rank& b) {
            return a.weight != b.weight ? a.weight > b.weight : a.id < b.id;
        });
        std::array<Rank, kRanks> out;
        std::copy_n(all.begin(), kRanks, out.begin());
        return out;
    }

    void scale(float share) {
        for (float& weight : bounds) weight *= share;
        for (float& weight : certain) weight *= share;
    }
};

}  // namespace lancret
