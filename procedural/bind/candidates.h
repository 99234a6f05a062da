#pragma once
// A child's candidates: the guides of its region, nearest first, reduced by partings and
// by the angle between scalp normals.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "guides/helix/guides.h"
#include "procedural/bind/guide_index.h"
#include "procedural/bind/partings.h"
#include "procedural/bind/settings.h"

namespace lancret {

/// Candidates in ascending distance; the arrays hold `size` entries.
struct Candidates {
    std::size_t size = 0;
    std::size_t within = 0;  ///< the first `within` may have a weight: those nearer than
                             ///< `reach`, or all if every one is a nearest neighbour
    double reach = 0;        ///< neighbour_reach, cm
    bool from_all_regions = false;  ///< because the child's own region has no guide
    std::array<std::uint32_t, kMaxCandidates> guides;
    std::array<double, kMaxCandidates> distances;  ///< cm
    std::array<double, kMaxCandidates> sights;     ///< 0 to 1: see `sight` in partings.h
    std::array<double, kMaxCandidates> shares;  ///< 0 to 1: sight times the falloff with
                                                ///< angle; 0 from the maximum distance on

    /// The nearest that no parting hides; nullopt if all are hidden.
    std::optional<std::size_t> first_in_sight() const;
};

/// Finds the candidates of one child after another without allocating per child. Keeps
/// references to its arguments.
class CandidateFinder {
  public:
    /// `normals` are the scalp's at the guides' roots; `partings` may be null.
    CandidateFinder(const GuideIndex& index, const Guides& guides,
                    std::span<const Vec3f> normals, const BindSettings& settings,
                    const Partings* partings)
        : index_(index),
          guides_(guides),
          normals_(normals),
          settings_(settings),
          partings_(partings) {}

    /// Returns the nearest guides until their shares sum to at least `k` + 1, at most
    /// kMaxCandidates. `place` is the child's root, cm, `up` the scalp's normal there.
    /// The result is valid until the next call.
    const Candidates& find(const Vec3& place, const Vec3& up, std::uint32_t region,
                           std::size_t k);

  private:
    double set_shares(const Vec3& place, const Vec3& up);

    const GuideIndex& index_;
    const Guides& guides_;
    std::span<const Vec3f> normals_;
    const BindSettings& settings_;
    const Partings* partings_;
    Candidates out_;
    std::array<double, kMaxCandidates> squared_;
    std::vector<SeenPiece> seen_;
    std::vector<std::pair<std::uint32_t, double>> scratch_;
};

}  // namespace lancret
