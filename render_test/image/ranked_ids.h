#pragma once
// Which ids cover most of a pixel, in the same few bytes however many there are.

#include <algorithm>
#include <array>
#include <cstdint>

namespace lancret {

/// The heaviest of a stream of ids [Metwally et al. 2005, "Efficient computation of
/// frequent and top-k elements": Space-Saving]. Every id that has more than 1 / kSlots of
/// all weight is here. Of each, the weight that it surely has is kept apart from what it
/// took over of those that it pushed out, so that no id is told to have more than it has;
/// up to kSlots different ids are exact.
struct RankedIds {
    static constexpr int kSlots = 12;

    std::array<std::uint32_t, kSlots> ids{};
    std::array<float, kSlots> bounds{};  ///< at most this; falling in no order; 0: free
    std::array<float, kSlots> own{};     ///< at least this

    void add(std::uint32_t id, float weight) {
        if (!(weight > 0)) return;
        int slot = 0, least = 0;
        for (; slot < kSlots && bounds[slot] > 0 && ids[slot] != id; ++slot)
            if (bounds[slot] < bounds[least]) least = slot;
        if (slot == kSlots) {
            slot = least;
            own[slot] = 0;
        }
        ids[slot] = id;
        bounds[slot] += weight;
        own[slot] += weight;
    }

    struct Rank {
        std::uint32_t id = 0;
        float weight = 0;  ///< that it surely has; 0: no such rank
    };
    /// The heaviest first; of equals, the smaller id.
    template <int kRanks>
    std::array<Rank, kRanks> ranks() const {
        static_assert(kRanks <= kSlots);
        std::array<Rank, kSlots> all;
        for (int i = 0; i < kSlots; ++i) all[i] = {ids[i], own[i]};
        std::ranges::sort(all, [](const Rank& a, const Rank& b) {
            return a.weight != b.weight ? a.weight > b.weight : a.id < b.id;
        });
        std::array<Rank, kRanks> out;
        std::copy_n(all.begin(), kRanks, out.begin());
        return out;
    }

    void scale(float share) {
        for (float& weight : bounds) weight *= share;
        for (float& weight : own) weight *= share;
    }
};

}  // namespace lancret
