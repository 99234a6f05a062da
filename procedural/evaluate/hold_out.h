#pragma once
// Holding out strands: a dense groom is split into strands that become guides and strands
// that the guides have to predict.

#include <string>

#include "guides/fit/super_helix_fit.h"
#include "guides/mesh/scalp.h"
#include "procedural/bind/binding.h"
#include "procedural/evaluate/strand_figures.h"
#include "procedural/groom/groom.h"

namespace lancret {

/// Steps per strand at which strands are compared.
inline constexpr int kCompareSteps = 64;

struct HoldOutSettings {
    GuideCount guides{.share = 0.05};
    std::optional<int> segments = {};  ///< of fitted guides; nullopt: guides are sampled
                                       ///< as finely as needed to keep their shape
    BindSettings bind = {};
    const Partings* partings = nullptr;  ///< children have no guides across these
    std::uint64_t seed = 0;              ///< selects the first guide
};

/// How closely guides follow the strands that they were made from.
struct GuideFit {
    bool fitted = false;  ///< by fit_guides, else by sample_guides
    Spread rms;           ///< over length
    DistributionFigures curvature;
};

/// A groom split into guides and held-out strands. `guides` and `binding` depend on a
/// held-out strand only through the position of its root, not on its direction or length.
struct HoldOut {
    std::vector<std::uint32_t> guide_strands;  ///< [guides], indices in the groom
    std::vector<std::uint32_t> child_strands;  ///< [children], held out, ascending
    Guides guides;
    GuideFit fit;
    Binding binding;               ///< children at the roots of the held-out strands
    StrandSamples truth;           ///< [children], the held-out strands at kCompareSteps
    std::vector<Vec3f> tangents;   ///< unit, at each point of `truth`
    std::vector<double> lengths;   ///< [children], of the held-out strands, cm
    std::size_t flat_strands = 0;  ///< ignored strands, shorter than 1e-6 cm
};

/// Splits a groom. Guides are selected by farthest-point sampling of the roots; the other
/// strands are bound at their own roots. Normals come from the scalp. Without a scalp
/// they are all the same, so no rotation is transported from guide to child and facing
/// has no effect. Throws InputError, prefixed with `name`, if no guide or no held-out
/// strand is left. The result is the same for any number of threads.
HoldOut hold_out(const Strands& strands, const Scalp* scalp,
                 const HoldOutSettings& settings, const std::string& name);

}  // namespace lancret
