#include "tools/preview/plan.h"

#include <fmt/format.h>

#include "guides/base/errors.h"

namespace lancret {

namespace {

/// Throws InputError if strands cannot have the faces that elliptic ones need.
void check_faces(const GroomSettings& groom) {
    if (groom.expand.shape.value_or(CurveShape::flat) == CurveShape::flat &&
        groom.expand.basis == CurveBasis::bspline) {
        return;
    }
    throw InputError(fmt::format(
        "{}: 'aspect' of [material] needs strands that are drawn as 'flat' B-splines; "
        "remove 'shape' and 'curve' from [strands]",
        groom.name));
}

}  // namespace

PreviewPlan plan_of(const PreviewOptions& options) {
    PreviewPlan plan;
    plan.job = read_job(options.groom);
    plan.chosen = chosen_frames(options.frames, plan.job, false);
    plan.outputs = outputs_of(options, plan.job, plan.chosen);
    set_override(options, plan.chosen, plan.job.preview);
    plan.view = view_request(options);
    plan.views = options.turntable ? plan.outputs.size() : 0;
    plan.elliptic = plan.job.preview.hair.aspect < 1;
    if (plan.elliptic) check_faces(plan.job.groom);
    check_points(plan.job.groom);
    return plan;
}

}  // namespace lancret
