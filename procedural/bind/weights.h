#pragma once
// How much each of its neighbours has to say in a child.

#include <limits>
#include <span>

#include "guides/base/types.h"

namespace lancret {

/// How far a child's `k` neighbours may be, cm: where every guide's share is 1 the
/// distance of guide k + 1, so that a guide that leaves the neighbours leaves them with
/// weight zero. Guides with a share below 1, half hidden by a parting, count for that
/// share alone:
///     1 / reach = integral from k to k + 1 of dm / Q(m),
/// Q(m) the least distance within which the shares add up to m, and `last` beyond all of
/// them: it bounds the reach. So the reach is continuous in every distance and share,
/// through changes of order and of number. `distances` ascend, cm; shares are 0 to 1.
double neighbour_reach(std::span<const double> distances, std::span<const double> shares,
                       std::size_t k,
                       double last = std::numeric_limits<double>::infinity());

/// What weights were made of.
enum class WeightSource {
    facing,    ///< distance and facing, as the paper has it
    distance,  ///< distance alone: no guide within reach faces
    none,      ///< nothing: no guide within reach has a share
};

/// The mean facing of a child's guides below which its weights begin to go over to those
/// by distance alone.
inline constexpr double kMinFacing = 0.05;

/// Weights of a child's nearest guides [TW99, Sec. 4.3 and Eq. 49]:
///     w_k ~ e_k f(|x - x_k|) (S.T_k) H(S.T_k),   f(d) = ((1/d - 1/reach)+)^a,
/// with Shepard's falloff to `reach` in place of the bare power, and e_k, the share that
/// the child has in a guide. `distances` ascend, cm; `facing` holds S.T_k. A reach of
/// infinity gives the paper's own power law. Where a root coincides with a guide's, that
/// guide has all the weight.
///
/// Where no guide faces, the paper's weights are 0 / 0, and which guide was the last to
/// face depends on the way there: so the facing factor is (S.T)+ + (kMinFacing - F)+, F
/// the mean of (S.T)+ by distance. Weights are the paper's own where F is kMinFacing or
/// more, by distance alone where F is 0, and continuous between.
///
/// Weights sum to 1, or are all 0 where the source is none.
WeightSource guide_weights(std::span<const double> distances,
                           std::span<const double> shares, double reach,
                           std::span<const double> facing, double exponent,
                           std::span<float> weights);

/// Leaves weight to `k` guides at most: every weight is lowered by the largest that must
/// go, so that who goes and who stays changes continuously, and the rest sums to 1 again.
/// Where nothing would be left, k + 1 being equally heavy, the first of the heaviest has
/// all: there weights jump.
void keep_heaviest(std::span<float> weights, std::size_t k);

}  // namespace lancret
