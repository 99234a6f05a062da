#pragma once
// How far made strands are from real ones: places, lengths and shapes. From points alone;
// it shares nothing with what made them. docs/evaluate.md says each figure exactly.

#include <span>
#include <vector>

#include "guides/base/quantile.h"
#include "guides/base/types.h"

namespace lancret {

/// Strands as points at equal steps of s / L, root first.
struct StrandSamples {
    int steps = 0;             ///< of each strand, >= 2
    std::vector<Vec3> points;  ///< [size * (steps + 1)], cm

    std::size_t size() const { return points.size() / std::size_t(steps + 1); }
    std::span<const Vec3> strand(std::size_t i) const {
        return std::span(points).subspan(i * (steps + 1), steps + 1);
    }
    std::span<Vec3> strand(std::size_t i) {
        return std::span(points).subspan(i * (steps + 1), steps + 1);
    }
};

/// How a distribution differs from the real one.
struct DistributionFigures {
    double w1 = 0;          ///< the 1-Wasserstein distance over the mean size of the real
    double mean_ratio = 1;  ///< of the mean size to the real one's
};

/// The figures of made strands; distances are over the real strand's length.
struct StrandFigures {
    Spread rms;    ///< over a strand's samples
    Spread place;  ///< the same after a low-pass of both strands
    Spread tip;    ///< of the last sample
    DistributionFigures curvature, torsion;
};

/// Compares strand by strand. `lengths` are of the real strands, [truth.size()], cm.
/// Sizes and steps agree and there is a strand, else std::invalid_argument. The same for
/// any number of threads.
StrandFigures strand_figures(const StrandSamples& truth, std::span<const double> lengths,
                             const StrandSamples& made);

/// The share of the length that is the standard deviation of the low-pass under which a
/// curl no longer counts as a wrong place.
inline constexpr double kPlaceSigma = 0.08;

/// A Gaussian of standard deviation kPlaceSigma over strands of `steps` steps, cut off at
/// four of them; beyond its ends a strand goes on as its end point.
class LowPass {
  public:
    explicit LowPass(int steps);
    /// `strand` and `out` have steps + 1 points and are not the same.
    void operator()(std::span<const Vec3> strand, std::span<Vec3> out) const;

  private:
    std::vector<double> kernel_;  ///< [2 radius + 1], sum 1
};

/// A value with the say that it has in a distribution.
struct Weighted {
    double value;
    double weight;  ///< >= 0
};

/// Curvature at the inner points of a strand: the turn of the polyline there over a step
/// of its own length, 1/cm. All weigh the same. [steps - 1], added to `out`.
void add_curvatures(std::span<const Vec3> strand, std::vector<Weighted>& out);

/// Torsion at the inner steps of a strand: the signed angle, about the step, from the
/// plane of the bend at its start to that of the bend at its end, over its length, 1/cm;
/// positive for a right-handed helix. The weight is the product of the two bends
/// (radian^2), as kappa^2 tau = det(r', r'', r''') stays defined where a strand is
/// straight and torsion does not. [steps - 2], added to `out`.
void add_torsions(std::span<const Vec3> strand, std::vector<Weighted>& out);

/// The two distributions compared by 199 quantiles, shares 0.005 to 0.995: the mean
/// distance between them over the mean size of the real ones. Sorts both. Where all that
/// is real is zero the distance is absolute and the ratio 1.
DistributionFigures compare(std::vector<Weighted>& real, std::vector<Weighted>& made);

}  // namespace lancret
