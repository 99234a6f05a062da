#pragma once
// The plan of a preview: everything that can be decided, and refused, before any work.

#include <vector>

#include "tools/preview/options.h"

namespace lancret {

struct PreviewPlan {
    Job job;  ///< with the options applied
    ChosenFrames chosen;
    std::vector<PictureFiles> outputs;  ///< one per frame, or per view of a turntable
    std::size_t views = 0;              ///< of a turntable; 0: none
    std::optional<ViewRequest> view;    ///< a check view
    bool elliptic = false;              ///< strands have elliptic sections

    /// The frame of picture `i`.
    double frame(std::size_t i) const { return chosen.frames[views ? 0 : i]; }
};

/// Throws InputError.
PreviewPlan plan_of(const PreviewOptions& options);

}  // namespace lancret
