#pragma once
// The check views of lancret preview: their figures and colour scales.

#include "render_test/trace/check_view.h"
#include "tools/job.h"
#include "tools/preview/shown_times.h"
#include "tools/preview/view_request.h"

namespace lancret {

/// The strands that a view shows. References must outlive it.
struct ViewSubject {
    const PluginGroom& plugin;
    const PluginStrands& strands;
    const ShownTime& shown;  ///< the first of their times
    const GroomSettings& groom;
    float aspect;  ///< of their section
};

/// Throws InputError if the groom lacks what the view shows.
CheckView view_of(const ViewRequest& request, const ViewSubject& subject);

/// Keeps the scale of the view for later pictures, unless a range was requested.
void keep_range(const CheckView& view, ViewRequest& request);

/// Greatest depth of each emitted curve below `surface`, cm, [strands]; 0 if it is
/// outside. Tests both ends and the middle of every segment.
StrandValues penetration_values(const Curves& curves, const TriangleMesh& surface);

}  // namespace lancret
