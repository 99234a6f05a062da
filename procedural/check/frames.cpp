#include "procedural/check/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "procedural/check/figures.h"

namespace lancret {

namespace {

/// A figure that one frame has one of, and the frame where it is largest.
struct Peak {
    double value = 0, frame = 0;
};

template <class Value>
Peak peak(const FramesReport& report, Value value) {
    Peak out{-1, 0};
    for (const FrameCheck& f : report.frames) {
        if (const double size = value(f); size > out.value) out = {size, f.frame};
    }
    return out;
}

/// A figure of the guides, as the reports name it.
struct GuideFigure {
    const char *key, *title;
    double GuideCheck::*value;
    double CheckTolerances::*tolerance;  ///< none: must be nothing
};
constexpr GuideFigure kGuideFigures[] = {
    {"orthogonality", "guides' frames |R^T R - I|", &GuideCheck::orthogonality,
     &CheckTolerances::orthogonality},
    {"length_change", "guides' lengths since rest", &GuideCheck::length_change, nullptr},
    {"root_cm", "guides' roots off the scalp, cm", &GuideCheck::root_distance,
     &CheckTolerances::root},
};

double tolerance_of(const GuideFigure& figure, const CheckTolerances& tolerances) {
    return figure.tolerance ? tolerances.*figure.tolerance : 0;
}

bool is_asked(const GuideFigure& figure, const FramesReport& report) {
    return figure.value != &GuideCheck::root_distance ||
           report.frames[0].guides.root_applies;
}

/// The size of a strand's figure; a NaN is as large as can be.
double size_of(float value) {
    return std::isnan(value) ? std::numeric_limits<double>::infinity()
                             : std::abs(double(value));
}

std::string line(const char* title, const Peak& peak, double tolerance, bool asked) {
    return fmt::format("{:32} {:10.2e} {:>8} {:>10}{}\n", title, peak.value, peak.frame,
                       asked ? fmt::format("{:.2e}", tolerance) : "not asked",
                       !asked || peak.value <= tolerance ? "" : "  <-- above");
}

}  // namespace

bool FramesReport::pass() const {
    return std::ranges::all_of(frames, &FrameCheck::pass) &&
           std::ranges::all_of(steps, &StepCheck::pass);
}

void add_step(FramesReport& report, double from, double to,
              const TemporalReport& motion) {
    // Places of some 1e2 cm round by 1e-14 of that in doubles, some 1e2 times over; the
    // guides' motion is at least 5e-4 cm.
    constexpr double kRounding = 1e-6;
    const bool pass = motion.share_of_limit <= 1 + kRounding;
    report.steps.push_back({from, to, motion, motion.motion.bound.has_value(), pass});
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
        out.outside_bound += !s.tip_within_reach;
        out.non_finite += !s.finite;
        for (const Figure& figure : kFigures) {
            float& largest = out.largest.*figure.value;
            largest = float(std::max(double(largest), size_of(s.*figure.value)));
        }
    }
    out.pass = out.failed == 0 && passes(guides, children.tolerances);
    const bool worse = std::ranges::all_of(
        report.frames, [&](const FrameCheck& f) { return out.severity > f.severity; });
    report.frames.push_back(out);
    if (worse) {
        report.worst = std::move(children);
        report.worst_frame = frame;
    }
}

namespace {

/// The step with the largest amplification, the first such.
const StepCheck& worst_step(const FramesReport& report) {
    return *std::ranges::max_element(
        report.steps, {}, [](const StepCheck& s) { return s.motion.amplification; });
}

std::string steps_table(const FramesReport& report) {
    if (report.steps.empty()) return {};
    const StepCheck& worst = worst_step(report);
    const StepCheck& tightest = *std::ranges::max_element(
        report.steps, {}, [](const StepCheck& s) { return s.motion.share_of_limit; });
    const ChildMotion& motion = worst.motion.motion;
    std::string out =
        fmt::format("{:32} {:10.3f} {:>8} {:>10}\n", "child's step over its guides'",
                    worst.motion.amplification, worst.to, "not asked");
    out += fmt::format(
        "  child {} from frame {} to {}: {:.4f} cm, its guides {:.4f} cm\n",
        worst.motion.child, worst.from, worst.to, motion.child, motion.guides);
    if (tightest.has_limit) {
        out += fmt::format("{:32} {:10.3f} {:>8} {:>10.2e}{}\n",
                           "child's step over its bound", tightest.motion.share_of_limit,
                           tightest.to, 1.0, tightest.pass ? "" : "  <-- above");
    }
    return out;
}

nlohmann::json step_json(const StepCheck& step) {
    return {{"from", frame_json(step.from)},
            {"to", frame_json(step.to)},
            {"amplification", number_json(step.motion.amplification)},
            {"child", step.motion.child},
            {"child_cm", number_json(step.motion.motion.child)},
            {"guides_cm", number_json(step.motion.motion.guides)},
            {"largest_child_cm", number_json(step.motion.largest_child)},
            {"largest_guides_cm", number_json(step.motion.largest_guides)},
            {"share_of_limit", step.has_limit ? number_json(step.motion.share_of_limit)
                                              : nlohmann::json(nullptr)},
            {"pass", step.pass}};
}

}  // namespace

std::string frames_table(const FramesReport& report) {
    const CheckTolerances& tolerances = report.worst.tolerances;
    std::string out = fmt::format("{:32} {:>10} {:>8} {:>10}\n",
                                  fmt::format("{} frames", report.frames.size()), "max",
                                  "in frame", "tolerance");
    for (const Figure& figure : kFigures) {
        const Peak at = peak(
            report, [&](const FrameCheck& f) { return double(f.largest.*figure.value); });
        out += line(figure.title, at, tolerances.*figure.tolerance, true);
    }
    for (const GuideFigure& figure : kGuideFigures) {
        const Peak at =
            peak(report, [&](const FrameCheck& f) { return f.guides.*figure.value; });
        out += line(figure.title, at, tolerance_of(figure, tolerances),
                    is_asked(figure, report));
    }
    out += steps_table(report);
    const auto counted = [&](const char* title, std::size_t FrameCheck::*count) {
        const Peak at =
            peak(report, [&](const FrameCheck& f) { return double(f.*count); });
        out += at.value > 0 ? fmt::format("{}: {:.0f} children in frame {}\n", title,
                                          at.value, at.frame)
                            : fmt::format("{}: none\n", title);
    };
    counted("kappa and tau outside the guides' hull", &FrameCheck::outside_hull);
    counted("tip outside the bound", &FrameCheck::outside_bound);
    counted("not finite", &FrameCheck::non_finite);
    const auto failed = std::ranges::find_if_not(report.frames, &FrameCheck::pass);
    const auto jumps = std::ranges::find_if_not(report.steps, &StepCheck::pass);
    if (failed == report.frames.end() && jumps != report.steps.end()) {
        out += fmt::format(
            "\nFAIL: {} of {} steps go beyond the blend's bound, the first is {} to {}\n",
            std::ranges::count(report.steps, false, &StepCheck::pass),
            report.steps.size(), jumps->from, jumps->to);
    } else if (failed == report.frames.end()) {
        out += fmt::format("\nPASS: all {} frames keep every tolerance\n",
                           report.frames.size());
    } else {
        out += fmt::format(
            "\nFAIL: {} of {} frames go beyond a tolerance, the first is {}\n",
            std::ranges::count(report.frames, false, &FrameCheck::pass),
            report.frames.size(), failed->frame);
    }
    return out;
}

nlohmann::json frames_json(const FramesReport& report) {
    const CheckTolerances& tolerances = report.worst.tolerances;
    nlohmann::json out;
    out["pass"] = report.pass();
    out["worst_frame"] = frame_json(report.worst_frame);
    out["frames"] = nlohmann::json::array();
    for (const FrameCheck& f : report.frames) {
        nlohmann::json entry = {{"frame", frame_json(f.frame)},
                                {"pass", f.pass},
                                {"failed", f.failed},
                                {"hull", {{"outside", f.outside_hull}}},
                                {"outside_bound", f.outside_bound},
                                {"non_finite", f.non_finite}};
        for (const Figure& figure : kFigures) {
            entry[figure.key][figure.max_key] = number_json(f.largest.*figure.value);
        }
        for (const GuideFigure& figure : kGuideFigures) {
            entry["guides"][figure.key] = number_json(f.guides.*figure.value);
        }
        entry["guides"]["finite"] = f.guides.finite;
        entry["guides"]["root_guide"] = f.guides.worst_root;
        entry["guides"]["pass"] = passes(f.guides, tolerances);
        out["frames"].push_back(std::move(entry));
    }
    nlohmann::json& worst = out["worst_over_frames"];
    const auto put = [](nlohmann::json& at, const char* max_key, const Peak& found,
                        double tolerance) {
        at = {{max_key, number_json(found.value)},
              {"frame", frame_json(found.frame)},
              {"tolerance", tolerance}};
    };
    for (const Figure& figure : kFigures) {
        put(worst[figure.key], figure.max_key,
            peak(report,
                 [&](const FrameCheck& f) { return double(f.largest.*figure.value); }),
            tolerances.*figure.tolerance);
    }
    for (const GuideFigure& figure : kGuideFigures) {
        put(worst["guides"][figure.key], "max",
            peak(report, [&](const FrameCheck& f) { return f.guides.*figure.value; }),
            tolerance_of(figure, tolerances));
        worst["guides"][figure.key]["asked"] = is_asked(figure, report);
    }
    if (!report.steps.empty()) {
        nlohmann::json& temporal = out["temporal"] = step_json(worst_step(report));
        double share = 0;
        for (const StepCheck& step : report.steps) {
            share = std::max(share, step.motion.share_of_limit);
        }
        temporal["share_of_limit"] =
            worst_step(report).has_limit ? number_json(share) : nlohmann::json(nullptr);
        for (const StepCheck& step : report.steps) {
            temporal["steps"].push_back(step_json(step));
        }
    }
    return out;
}

}  // namespace lancret
