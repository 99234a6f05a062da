#pragma once
// The stations of all strands and the nearby stations of other strands.

#include <vector>

#include "guides/helix/guides.h"
#include "sim/contact/contact.h"
#include "sim/contact/strand_grid.h"

namespace lancret {

/// Finds, at the start of a step, the neighbours of each station at its end.
class StrandNeighbours {
  public:
    /// `pasts` ([guides]) give the strands' velocities; `eps` is the duration of the
    /// step, s. Does not allocate once it has seen the same guides.
    void find(const Guides& guides, std::span<const RodPast> pasts, double radius,
              int stations, double eps);

    /// The arrays of RodContact::Strand for guide g.
    std::span<const Vec3> positions(std::size_t g) const { return of(positions_, g, 1); }
    std::span<const StrandNear> near(std::size_t g) const {
        return of(near_, g, RodContact::kMaxNear);
    }
    std::span<const std::uint8_t> counts(std::size_t g) const {
        return of(counts_, g, 1);
    }

  private:
    template <class T>
    std::span<const T> of(const std::vector<T>& all, std::size_t g,
                          std::size_t each) const {
        const std::size_t n = per_guide_ * each;
        return std::span(all).subspan(g * n, n);
    }

    std::size_t per_guide_ = 0;
    std::vector<Vec3> positions_, moves_, tangents_;
    std::vector<std::uint32_t> strands_;
    std::vector<StrandNear> near_;
    std::vector<std::uint8_t> counts_;
    StrandGrid grid_;
};

}  // namespace lancret
