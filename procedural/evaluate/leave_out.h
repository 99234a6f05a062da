#pragma once
// Leave-out: a dense groom's strands in two, those that become guides and those that the
// guides have to predict.

#include <string>

#include "guides/fit/super_helix_fit.h"
#include "guides/mesh/scalp.h"
#include "procedural/bind/binding.h"
#include "procedural/evaluate/strand_figures.h"
#include "procedural/groom/groom.h"

namespace lancret {

/// Steps at which strands are compared.
inline constexpr int kCompareSteps = 64;

struct LeaveOutSettings {
    GuideCount guides{.share = 0.05};
    std::optional<int> segments = {};  ///< a guide is fitted so; none: read as finely as
                                       ///< it takes to keep its shape
    BindSettings bind = {};
    const Partings* partings = nullptr;  ///< that no child's guides lie across
    std::uint64_t seed = 0;              ///< of the first guide
};

/// How near the guides come to the strands that they were made of.
struct GuideFit {
    bool fitted = false;  ///< fit_guides rather than sample_guides
    Spread rms;           ///< over length
    DistributionFigures curvature;
};

/// A groom taken apart. Of a left-out strand nothing but its root's position is in
/// `guides` and `binding`, not its direction nor its length.
struct HoldOut {
    std::vector<std::uint32_t> guide_strands;  ///< [guides] in the groom's numbers
    std::vector<std::uint32_t> child_strands;  ///< [children], ascending
    Guides guides;
    GuideFit fit;
    Binding binding;              ///< of the children, at the left-out strands' own roots
    StrandSamples truth;          ///< [children], at kCompareSteps
    std::vector<Vec3f> tangents;  ///< there, unit
    std::vector<double> lengths;  ///< [children] of the left-out strands, cm
    std::size_t flat_strands = 0;  ///< without a length (below 1e-6 cm), left aside
};

/// Takes a groom apart: guides by farthest point on the roots, the rest bound at their
/// own roots. Normals are the scalp's; without one all are the same, so that nothing is
/// turned from guide to child, and facing has no say. Throws InputError, beginning with
/// `name`, where there is no guide or nothing is left out. The same for any number of
/// threads.
HoldOut leave_out(const Strands& strands, const Scalp* scalp,
                  const LeaveOutSettings& settings, const std::string& name);

}  // namespace lancret
