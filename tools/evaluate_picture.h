#pragma once
// The left-out strands side by side: as they are, and as each blend makes them.

#include <functional>
#include <string>
#include <vector>

#include "procedural/evaluate/evaluation.h"
#include "render_test/image/image.h"
#include "render_test/settings/preview.h"

namespace lancret {

/// How a strip is seen: `render` sizes a panel; the camera is one for all and frames the
/// truth.
struct StripView {
    PreviewSettings preview;
    Vec3f up = Vec3f::UnitY();
    Taper taper;
    std::optional<TriangleMesh> body;  ///< shown under the strands
};

/// The truth, then each blend's strands, left to right, each with its name under it.
/// `progress` gets the share done.
Image evaluation_strip(const HoldOut& taken, const GuideProfiles<float>& profiles,
                       const std::vector<Blend>& blends, const StripView& view,
                       const std::function<void(double done)>& progress);

}  // namespace lancret
