#pragma once
// Compares synthesised strands with real ones: places, lengths and shapes. It sees only
// points and shares no code with the blends. docs/evaluate.md defines each figure.

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

/// How the distribution of a quantity differs from that of the real strands.
struct DistributionFigures {
    double w1 = 0;          ///< 1-Wasserstein distance over the real mean magnitude
    double mean_ratio = 1;  ///< mean magnitude over the real mean magnitude
};

/// The figures of synthesised strands. Distances are relative to the real strand's
/// length.
struct StrandFigures {
    Spread rms;    ///< RMS distance over the samples of a strand
    Spread place;  ///< RMS distance after a low-pass of both strands
    Spread tip;    ///< distance of the last samples
    DistributionFigures curvature, torsion;
};

/// Compares strand by strand. `lengths` are those of the real strands, [truth.size()],
/// cm. Throws std::invalid_argument if sizes or steps differ or there is no strand. The
/// result is the same for any number of threads.
StrandFigures strand_figures(const StrandSamples& truth, std::span<const double> lengths,
                             const StrandSamples& made);

/// Standard deviation of the low-pass as a fraction of the length: wide enough that the
/// phase of a curl does not count as a wrong place.
inline constexpr double kPlaceSigma = 0.08;

/// A Gaussian filter of standard deviation kPlaceSigma, truncated at four standard
/// deviations, for strands of `steps` steps. Beyond its ends a strand is constant.
class LowPass {
  public:
    explicit LowPass(int steps);
    /// `strand` and `out` have steps + 1 points and must not overlap.
    void operator()(std::span<const Vec3> strand, std::span<Vec3> out) const;

  private:
    std::vector<double> kernel_;  ///< [2 radius + 1], sum 1
};

/// A value and its weight in a distribution.
struct Weighted {
    double value;
    double weight;  ///< >= 0
};

/// Appends the curvature at each inner point of a strand, [steps - 1]: the turning angle
/// of the polyline over the strand's mean step length, 1/cm. All weights are 1.
void add_curvatures(std::span<const Vec3> strand, std::vector<Weighted>& out);

/// Appends the torsion at each inner step of a strand, [steps - 2]: the signed angle
/// about the step from the plane of the bend at its start to that of the bend at its end,
/// over the step's length, 1/cm, positive for a right-handed helix. The weight is the
/// product of the two turning angles (radian^2): torsion is undefined on straight parts,
/// but kappa^2 tau = det(r', r'', r''') is not.
void add_torsions(std::span<const Vec3> strand, std::vector<Weighted>& out);

/// Compares two distributions by 199 quantiles, 0.005 to 0.995: the mean distance between
/// them over the mean magnitude of the real ones. Sorts both. If all real quantiles are 0
/// the distance is absolute; if the real mean is 0 the ratio is 1.
DistributionFigures compare(std::vector<Weighted>& real, std::vector<Weighted>& made);

}  // namespace lancret
