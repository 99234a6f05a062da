#pragma once
// How strongly each neighbouring guide influences a child.

#include <limits>
#include <span>

#include "guides/base/types.h"

namespace lancret {

/// The distance, cm, at which the weights of a child's `k` neighbours fall to zero. If
/// all shares are 1, it is the distance of guide k + 1, so that a guide that stops being
/// a neighbour has weight zero then. A guide with a share below 1, for example half
/// hidden by a parting, counts only as that share of a guide:
///     1 / reach = integral from k to k + 1 of dm / Q(m),
/// where Q(m) is the smallest distance within which the shares sum to m, and `last` if
/// they do not; `last` is an upper limit of the reach. The reach is therefore continuous
/// in every distance and share, through changes of order and number. `distances` ascend,
/// cm; shares are 0 to 1.
double neighbour_reach(std::span<const double> distances, std::span<const double> shares,
                       std::size_t k,
                       double last = std::numeric_limits<double>::infinity());

/// The factors that determined a child's weights.
enum class WeightSource {
    facing,    ///< distance and facing, as in the paper
    distance,  ///< distance only: no guide within reach faces the child
    none,      ///< no guide within reach has a share above 0: all weights are 0
};

/// The mean facing of a child's guides below which its weights begin to pass to those by
/// distance only.
inline constexpr double kMinFacing = 0.05;

/// Weights of a child's nearest guides [TW99, Sec. 4.3 and Eq. 49]:
///     w_k ~ e_k f(|x - x_k|) (S.T_k) H(S.T_k),   f(d) = ((1/d - 1/reach)+)^a,
/// with Shepard's falloff to `reach` in place of the plain power, and e_k = `shares`[k].
/// `distances` ascend, cm; `facing` holds S.T_k. An infinite reach gives the paper's
/// power law. A guide whose root coincides with the child's has all the weight.
///
/// If no guide faces the child, the paper's weights are 0 / 0, and their limit depends on
/// the path to that point. So the facing factor is (S.T)+ + (kMinFacing - F)+, where F is
/// the mean of (S.T)+ weighted by distance: weights are the paper's if F >= kMinFacing,
/// by distance only if F is 0, and continuous between.
///
/// Weights sum to 1, or are all 0 if the source is none.
WeightSource guide_weights(std::span<const double> distances,
                           std::span<const double> shares, double reach,
                           std::span<const double> facing, double exponent,
                           std::span<float> weights);

/// Leaves at most `k` weights above 0: subtracts the largest weight that has to go from
/// all weights, so that the choice changes continuously, and divides the rest by their
/// sum. If nothing remains because k + 1 guides are equally heavy, the first of the
/// heaviest has weight 1; there weights jump.
void keep_heaviest(std::span<float> weights, std::size_t k);

}  // namespace lancret
