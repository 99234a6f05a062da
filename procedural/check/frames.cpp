#include "procedural/check/frames.h"

#include <algorithm>

#include "procedural/check/figures.h"

namespace lancret {

bool FramesReport::pass() const {
    return std::ranges::all_of(frames, &FrameCheck::pass) &&
           std::ranges::all_of(steps, &StepCheck::pass);
}

void add_step(FramesReport& report, double from, double to, const MotionReport& motion) {
    // Places of some 100 cm are rounded by 1e-14 of that in doubles, about 100 times; the
    // guides' motion counts as at least 5e-4 cm.
    constexpr double kRounding = 1e-6;
    const bool pass = motion.share_of_limit <= 1 + kRounding;
    report.steps.push_back({from, to, motion, motion.motion.limit.has_value(), pass});
}

void add_frame(FramesReport& report, double frame, CheckReport children,
               const GuideCheck& guides) {
    FrameCheck out;
    out.frame = frame;
    out.guides = guides;
    for (const StrandCheck& s : children.strands) {
        const double severity = children.severity(s);
        out.severity = std::max(out.severity, severity);
        out.failed += severity > 1;
        out.outside_hull += !s.inside_hull;
        out.out_of_reach += !s.tip_within_reach;
        out.non_finite += !s.finite;
    }
    out.largest = largest_figures(children);
    out.pass = out.failed == 0 && passes(guides, children.tolerances);
    const bool worse = std::ranges::all_of(
        report.frames, [&](const FrameCheck& f) { return out.severity > f.severity; });
    report.frames.push_back(out);
    if (worse) {
        report.worst = std::move(children);
        report.worst_frame = frame;
    }
}

}  // namespace lancret
