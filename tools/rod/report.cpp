#include "tools/rod/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "guides/base/errors.h"
#include "sim/equilibrium/measures.h"

namespace lancret {

namespace {

nlohmann::json array(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Vec3 tip_of(const RodReport& report, const Eigen::VectorXd& q) {
    return rod_joints(report.rod, q).back().position;
}

nlohmann::json energy_json(const HangingEnergy& energy) {
    return {{"elastic", energy.elastic},
            {"gravity", energy.gravity},
            {"total", energy.total()}};
}

/// Adds the release to the JSON: the keys of the equilibrium move into `equilibrium`, and
/// those of the motion take their place.
void add_release(const RodReport& report, nlohmann::json& out) {
    const RodRelease& release = *report.release;
    nlohmann::json equilibrium;
    for (const char* key : {"tip", "energy", "curvatures"}) equilibrium[key] = out[key];
    out["equilibrium"] = equilibrium;
    out["energy"] = nlohmann::json::array();
    for (const ReleaseSample& s : release.samples) {
        out["energy"].push_back({{"t", s.time},
                                 {"kinetic", s.kinetic},
                                 {"elastic", s.elastic},
                                 {"gravity", s.weight},
                                 {"total", s.total()}});
    }
    const std::optional<double> drift = energy_drift(report);
    out["energy_drift"] = drift ? nlohmann::json(*drift) : nlohmann::json();
    out["largest_rise"] = release.largest_rise;
    out["tip"] = array(tip_of(report, release.q));
    out["curvatures"] = nlohmann::json::array();
    for (std::size_t i = 0; i < report.rod.segments(); ++i) {
        out["curvatures"].push_back(array(release.q.segment<3>(3 * i)));
    }
    out["time"] = release.samples.back().time;
    out["steps"] = release.steps;
    out["unconverged_steps"] = release.unconverged;
    out["finished"] = release.finished;
    out["damping"] = report.setup.damping;
}

double root_curvature(const RodReport& report) {
    return root_darboux(report.rod, report.equilibrium.q).tail<2>().norm();
}

}  // namespace

HangingRod rod_of(const RodSetup& setup) {
    // Scaled first, so that squares neither overflow nor underflow.
    const auto unit = [](const Vec3& v, const char* option) -> Vec3 {
        const double size = v.cwiseAbs().maxCoeff();
        if (!v.allFinite() || !(size > 0)) {
            throw InputError(
                fmt::format("{}: ({}, {}, {}) has no direction: expected three finite "
                            "numbers, not all 0",
                            option, v.x(), v.y(), v.z()));
        }
        return (v / size).normalized();
    };
    const Vec3 tangent = unit(setup.root_tangent, "--root-tangent");
    Vec3 hint = Vec3::UnitZ();
    if (setup.root_normal) {
        hint = unit(*setup.root_normal, "--root-normal");
    } else if (tangent.cross(hint).norm() < 1e-6) {
        hint = Vec3::UnitX();
    }
    const Vec3 across = hint - tangent.dot(hint) * tangent;
    if (!(across.norm() > 1e-9)) {
        throw InputError("--root-normal: must not be parallel to the root tangent");
    }
    if (!setup.natural.allFinite() || setup.natural.cwiseAbs().maxCoeff() > 1e4) {
        throw InputError("--natural: expected three numbers from -10000 to 10000");
    }
    HangingRod rod;
    rod.root.frame.col(0) = tangent;
    rod.root.frame.col(1) = across.normalized();
    rod.root.frame.col(2) = tangent.cross(rod.root.frame.col(1));
    for (int i = 0; i < 4; ++i) orthonormalize(rod.root.frame);
    rod.lengths.assign(setup.segments, 1. / setup.segments);
    rod.natural.assign(setup.segments, setup.natural);
    rod.section.stiffness = {setup.torsion_ratio, 1, setup.bending_ratio};
    rod.section.damping = setup.damping * rod.section.stiffness;
    rod.gravity = -setup.gamma * Vec3::UnitZ();
    return rod;
}

std::optional<double> critical_gamma(const RodReport& report) {
    if (!report.changes) return std::nullopt;
    for (const StabilityChange& change : *report.changes) {
        if (!change.stable) return change.weight;
    }
    return std::nullopt;
}

std::optional<double> energy_drift(const RodReport& report) {
    if (!report.release || !report.equilibrium.converged) return std::nullopt;
    const double first = report.release->samples.front().total();
    const double depth = first - report.equilibrium.energy.total();
    // Many times the round-off of either energy.
    if (!(depth > 1e-12 * (report.setup.gamma + 1))) return std::nullopt;
    return report.release->largest_change / depth;
}

std::string rod_table(const RodReport& report) {
    const RodEquilibrium& equilibrium = report.equilibrium;
    const Vec3 tip = tip_of(report, equilibrium.q);
    const LowestPoint low = lowest_point(report.rod, equilibrium.q, Vec3::UnitZ());
    std::string out;
    const auto row = [&](const char* name, const std::string& value) {
        out += fmt::format("{:<16}{}\n", name, value);
    };
    row("gamma", fmt::format("{}", report.setup.gamma));
    row("tip", fmt::format("{:.8f} {:.8f} {:.8f}", tip.x(), tip.y(), tip.z()));
    row("tip angle", fmt::format("{:.8f} rad", tip_angle(report.rod, equilibrium.q)));
    row("lowest", fmt::format("{:.8f} at s = {:.6f}", low.height, low.s));
    row("root curvature", fmt::format("{:.8f}", root_curvature(report)));
    row("energy", fmt::format("{:.8g} elastic, {:.8g} gravity, {:.8g} total",
                              equilibrium.energy.elastic, equilibrium.energy.gravity,
                              equilibrium.energy.total()));
    row("stable",
        fmt::format(
            "{} (smallest eigenvalue {:.6g}){}", equilibrium.stable ? "yes" : "no",
            equilibrium.smallest_eigenvalue,
            equilibrium.left_branch ? ", does not continue the natural shape" : ""));
    if (!report.modes.empty()) {
        row("frequencies", fmt::format("{:.6f}", fmt::join(report.modes, " ")));
    }
    if (report.changes && report.changes->empty()) {
        row("buckling", fmt::format("none up to gamma {:g}", report.max_gamma));
    } else if (report.changes) {
        for (const StabilityChange& change : *report.changes) {
            row("buckling", fmt::format("{} at gamma {:.8f}{}",
                                        change.stable ? "stable again" : "unstable",
                                        change.weight, change.fold ? ", by a snap" : ""));
        }
    }
    if (report.release) {
        const RodRelease& release = *report.release;
        const Vec3 end = tip_of(report, release.q);
        const std::optional<double> drift = energy_drift(report);
        row("release", fmt::format("{} steps to t = {:g}{}", release.steps,
                                   double(release.samples.back().time),
                                   release.finished ? "" : "; the next step failed"));
        row("  tip", fmt::format("{:.8f} {:.8f} {:.8f}", end.x(), end.y(), end.z()));
        row("  energy drift", drift ? fmt::format("{:.3g}", *drift) : "undefined");
    }
    return out;
}

nlohmann::json rod_json(const RodReport& report) {
    const RodSetup& setup = report.setup;
    const RodEquilibrium& equilibrium = report.equilibrium;
    const LowestPoint low = lowest_point(report.rod, equilibrium.q, Vec3::UnitZ());
    nlohmann::json out = {
        {"gamma", setup.gamma},
        {"natural", array(setup.natural)},
        {"root_tangent", array(report.rod.root.frame.col(0))},
        {"root_normal", array(report.rod.root.frame.col(1))},
        {"torsion_ratio", setup.torsion_ratio},
        {"bending_ratio", setup.bending_ratio},
        {"segments", setup.segments},
        {"tip", array(tip_of(report, equilibrium.q))},
        {"tip_angle", tip_angle(report.rod, equilibrium.q)},
        {"lowest", low.height},
        {"lowest_at", low.s},
        {"root_curvature", root_curvature(report)},
        {"root_darboux", array(root_darboux(report.rod, equilibrium.q))},
        {"energy", energy_json(equilibrium.energy)},
        {"stable", equilibrium.stable},
        {"converged", equilibrium.converged},
        {"left_branch", equilibrium.left_branch},
        {"snaps", equilibrium.snaps},
        {"smallest_eigenvalue", equilibrium.smallest_eigenvalue},
        {"modes", report.modes},
    };
    for (std::size_t i = 0; i < report.rod.segments(); ++i) {
        out["curvatures"].push_back(array(equilibrium.q.segment<3>(3 * i)));
    }
    const std::optional<double> critical = critical_gamma(report);
    out["critical_gamma"] = critical ? nlohmann::json(*critical) : nlohmann::json();
    if (report.changes) {
        out["searched_to_gamma"] = report.max_gamma;
        out["stability_changes"] = nlohmann::json::array();
        for (const StabilityChange& change : *report.changes) {
            out["stability_changes"].push_back({{"gamma", change.weight},
                                                {"stable", change.stable},
                                                {"snap", change.fold}});
        }
    }
    if (report.release) add_release(report, out);
    return out;
}

}  // namespace lancret
