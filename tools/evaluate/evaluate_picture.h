#pragma once
// A picture of the held-out strands next to each blend's prediction of them.

#include <functional>
#include <string>
#include <vector>

#include "procedural/evaluate/evaluation.h"
#include "render_test/image/image.h"
#include "render_test/settings/preview.h"

namespace lancret {

/// The strands of a strip.
struct StripStrands {
    const HoldOut& holdout;
    const GuideProfiles<float>& profiles;  ///< of its guides
    const std::vector<Blend>& blends;
};

/// How a strip is rendered. `preview.render` has the size of one panel; all panels share
/// one camera, which frames the real strands.
struct StripView {
    PreviewSettings preview;
    Vec3f up = Vec3f::UnitY();
    Taper taper;
    std::optional<TriangleMesh> body;  ///< rendered below the strands
};

/// One panel with the real strands, then one per blend, from left to right, each with its
/// name below. `progress` receives the completed fraction.
Image evaluation_strip(const StripStrands& strands, const StripView& view,
                       const std::function<void(double done)>& progress);

}  // namespace lancret
