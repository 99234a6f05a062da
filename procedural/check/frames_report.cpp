#include "procedural/check/frames_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "guides/base/json_numbers.h"
#include "procedural/check/figures.h"

namespace lancret {

namespace {

/// The largest value of a figure over the frames.
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

Peak peak(const FramesReport& report, const Figure& figure) {
    return peak(report,
                [&](const FrameCheck& f) { return double(f.largest.*figure.value); });
}

/// A measurement of the guides and its names in reports.
struct GuideFigure {
    const char *key, *title;
    double GuideCheck::*value;
    double CheckTolerances::*tolerance;  ///< null: the tolerance is 0
};
constexpr GuideFigure kGuideFigures[] = {
    {"orthogonality", "guides' frames |R^T R - I|", &GuideCheck::orthogonality,
     &CheckTolerances::orthogonality},
    {"length_change", "guides' lengths since rest", &GuideCheck::length_change, nullptr},
    {"root_cm", "guides' roots off the scalp, cm", &GuideCheck::root_distance,
     &CheckTolerances::root},
};

Peak peak(const FramesReport& report, const GuideFigure& figure) {
    return peak(report, [&](const FrameCheck& f) { return f.guides.*figure.value; });
}

double tolerance_of(const GuideFigure& figure, const CheckTolerances& tolerances) {
    return figure.tolerance ? tolerances.*figure.tolerance : 0;
}

bool applies(const GuideFigure& figure, const FramesReport& report) {
    return figure.value != &GuideCheck::root_distance ||
           report.frames[0].guides.root_applies;
}

/// The step with the largest amplification, the first if several share it.
const StepCheck& worst_step(const FramesReport& report) {
    return *std::ranges::max_element(
        report.steps, {}, [](const StepCheck& s) { return s.motion.amplification; });
}

std::string line(const char* title, const Peak& peak, double tolerance, bool checked) {
    return fmt::format("{:32} {:10.2e} {:>8} {:>11}{}\n", title, peak.value, peak.frame,
                       checked ? fmt::format("{:.2e}", tolerance) : "not checked",
                       !checked || peak.value <= tolerance ? "" : "  <-- above");
}

std::string steps_lines(const FramesReport& report) {
    if (report.steps.empty()) return {};
    const StepCheck& worst = worst_step(report);
    const StepCheck& tightest = *std::ranges::max_element(
        report.steps, {}, [](const StepCheck& s) { return s.motion.share_of_limit; });
    const ChildMotion& motion = worst.motion.motion;
    std::string out =
        fmt::format("{:32} {:10.3f} {:>8} {:>11}\n", "child's step over its guides'",
                    worst.motion.amplification, worst.to, "not checked");
    out += fmt::format(
        "  child {} from frame {} to {}: {:.4f} cm, its guides {:.4f} cm\n",
        worst.motion.child, worst.from, worst.to, motion.child, motion.guides);
    if (tightest.has_limit) {
        out += fmt::format("{:32} {:10.3f} {:>8} {:>11.2e}{}\n",
                           "child's step over its limit", tightest.motion.share_of_limit,
                           tightest.to, 1.0, tightest.pass ? "" : "  <-- above");
    }
    return out;
}

std::string verdict(const FramesReport& report) {
    const auto failed = std::ranges::find_if_not(report.frames, &FrameCheck::pass);
    const auto jump = std::ranges::find_if_not(report.steps, &StepCheck::pass);
    if (failed != report.frames.end()) {
        return fmt::format(
            "\nFAIL: {} of {} frames exceed a tolerance, the first is {}\n",
            std::ranges::count(report.frames, false, &FrameCheck::pass),
            report.frames.size(), failed->frame);
    }
    if (jump != report.steps.end()) {
        return fmt::format(
            "\nFAIL: {} of {} steps exceed the blend's limit, the first is {} to {}\n",
            std::ranges::count(report.steps, false, &StepCheck::pass),
            report.steps.size(), jump->from, jump->to);
    }
    return fmt::format("\nPASS: all {} frames keep every tolerance\n",
                       report.frames.size());
}

}  // namespace

std::string frames_table(const FramesReport& report) {
    const CheckTolerances& tolerances = report.worst.tolerances;
    std::string out = fmt::format("{:32} {:>10} {:>8} {:>11}\n",
                                  fmt::format("{} frames", report.frames.size()), "max",
                                  "in frame", "tolerance");
    for (const Figure& figure : kFigures) {
        out +=
            line(figure.title, peak(report, figure), tolerances.*figure.tolerance, true);
    }
    for (const GuideFigure& figure : kGuideFigures) {
        out += line(figure.title, peak(report, figure), tolerance_of(figure, tolerances),
                    applies(figure, report));
    }
    out += steps_lines(report);
    const auto counted = [&](const char* title, std::size_t FrameCheck::*count) {
        const Peak most =
            peak(report, [&](const FrameCheck& f) { return double(f.*count); });
        out += most.value > 0 ? fmt::format("{}: {:.0f} children in frame {}\n", title,
                                            most.value, most.frame)
                              : fmt::format("{}: none\n", title);
    };
    counted("kappa and tau outside the guides' hull", &FrameCheck::outside_hull);
    counted("tip out of reach", &FrameCheck::out_of_reach);
    counted("not finite", &FrameCheck::non_finite);
    return out + verdict(report);
}

namespace {

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

nlohmann::json motion_json(const FramesReport& report) {
    nlohmann::json out = step_json(worst_step(report));
    double share = 0;
    for (const StepCheck& step : report.steps) {
        share = std::max(share, step.motion.share_of_limit);
    }
    out["share_of_limit"] =
        worst_step(report).has_limit ? number_json(share) : nlohmann::json(nullptr);
    for (const StepCheck& step : report.steps) out["steps"].push_back(step_json(step));
    return out;
}

nlohmann::json frame_check_json(const FrameCheck& f, const CheckTolerances& tolerances) {
    nlohmann::json out = {{"frame", frame_json(f.frame)},
                          {"pass", f.pass},
                          {"failed", f.failed},
                          {"hull", {{"outside", f.outside_hull}}},
                          {"out_of_reach", f.out_of_reach},
                          {"non_finite", f.non_finite}};
    for (const Figure& figure : kFigures) {
        out[figure.key][figure.max_key] = number_json(f.largest.*figure.value);
    }
    for (const GuideFigure& figure : kGuideFigures) {
        out["guides"][figure.key] = number_json(f.guides.*figure.value);
    }
    out["guides"]["finite"] = f.guides.finite;
    out["guides"]["root_guide"] = f.guides.worst_root;
    out["guides"]["pass"] = passes(f.guides, tolerances);
    return out;
}

nlohmann::json peak_json(const char* max_key, const Peak& peak, double tolerance) {
    return {{max_key, number_json(peak.value)},
            {"frame", frame_json(peak.frame)},
            {"tolerance", tolerance}};
}

nlohmann::json worst_json(const FramesReport& report) {
    const CheckTolerances& tolerances = report.worst.tolerances;
    nlohmann::json out;
    for (const Figure& figure : kFigures) {
        out[figure.key] =
            peak_json(figure.max_key, peak(report, figure), tolerances.*figure.tolerance);
    }
    for (const GuideFigure& figure : kGuideFigures) {
        nlohmann::json& entry = out["guides"][figure.key];
        entry = peak_json("max", peak(report, figure), tolerance_of(figure, tolerances));
        entry["applies"] = applies(figure, report);
    }
    return out;
}

}  // namespace

nlohmann::json frames_json(const FramesReport& report) {
    nlohmann::json out;
    out["pass"] = report.pass();
    out["worst_frame"] = frame_json(report.worst_frame);
    out["frames"] = nlohmann::json::array();
    for (const FrameCheck& f : report.frames) {
        out["frames"].push_back(frame_check_json(f, report.worst.tolerances));
    }
    out["worst_over_frames"] = worst_json(report);
    if (!report.steps.empty()) out["motion"] = motion_json(report);
    return out;
}

}  // namespace lancret
