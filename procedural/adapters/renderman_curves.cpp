#include "procedural/adapters/renderman_curves.h"

#include <algorithm>
#include <array>
#include <string>

namespace lancret {
namespace {

/// The arguments of RiBasis and RiCurves for a basis.
struct RiCurveBasis {
    RtBasis* matrix;  ///< null: linear
    RtInt step;       ///< vertices per segment
};

RiCurveBasis ri_basis(int basis) {
    switch (basis) {
        case LANCRET_BSPLINE:
            return {&RiBSplineBasis, 1};
        case LANCRET_CATMULL_ROM:
            return {&RiCatmullRomBasis, 1};
        case LANCRET_BEZIER:
            return {&RiBezierBasis, 3};
        case LANCRET_HERMITE:
            return {&RiHermiteBasis, 2};
        default:
            return {nullptr, 1};
    }
}

void add_xyz(std::vector<RtFloat>& out, const float* point) {
    out.insert(out.end(), point, point + 3);
}

/// Radii, and so widths, are control values of the same spline as the points.
CurvesAtTime curves_at(const lancret_curves& curves, std::size_t time) {
    CurvesAtTime out;
    const float* points = curves.positions[time];
    const bool hermite = curves.basis == LANCRET_HERMITE;
    const std::size_t vertices = std::size_t(hermite ? 2 : 1) * curves.points;
    out.points.reserve(3 * vertices);
    out.widths.reserve(vertices);
    for (std::size_t i = 0; i < curves.points; ++i) {
        add_xyz(out.points, points + 4 * i);
        out.widths.push_back(2 * points[4 * i + 3]);
        if (!hermite) continue;
        const float* tangent = curves.tangents[time] + 4 * i;
        add_xyz(out.points, tangent);
        out.widths.push_back(2 * tangent[3]);
    }
    if (curves.normals) {
        out.normals.reserve(3 * curves.points);
        for (std::size_t i = 0; i < curves.points; ++i) {
            add_xyz(out.normals, curves.normals[time] + 4 * i);
        }
    }
    return out;
}

std::vector<RtInt> integers(const lancret_u32* values, std::size_t n) {
    return {values, values + n};
}

std::vector<RtFloat> floats(const float* values, std::size_t n) {
    return {values, values + n};
}

/// Reduces the widths to a single one if all are equal at all times.
void join_widths(RiCurvesData& data) {
    if (data.basis == LANCRET_HERMITE) return;
    const RtFloat first = data.times.front().widths.front();
    for (const CurvesAtTime& time : data.times) {
        if (!std::ranges::all_of(time.widths, [&](RtFloat w) { return w == first; })) {
            return;
        }
    }
    for (CurvesAtTime& time : data.times) time.widths = {first};
}

void emit_once(const RiCurvesData& data, const CurvesAtTime& time) {
    const bool hermite = data.basis == LANCRET_HERMITE;
    std::vector<std::string> names;
    std::vector<RtPointer> values;
    // Ri reads through pointers to non-const.
    const auto add = [&](std::string name, const auto& numbers) {
        names.push_back(std::move(name));
        using T = typename std::decay_t<decltype(numbers)>::value_type;
        values.push_back(const_cast<T*>(numbers.data()));
    };
    add("P", time.points);
    if (time.widths.size() == 1) {
        add("constantwidth", time.widths);
    } else {
        add("vertex float width", time.widths);
    }
    if (!time.normals.empty()) {
        add(hermite ? "varying normal N" : "vertex normal N", time.normals);
    }
    for (const Primvar& primvar : data.primvars) {
        std::string name = primvar.declaration;
        if (const auto bracket = name.find("[]"); bracket != name.npos) {
            name.insert(bracket + 1, std::to_string(data.neighbours));
        }
        if (primvar.ints.empty()) {
            add(std::move(name), primvar.floats);
        } else {
            add(std::move(name), primvar.ints);
        }
    }
    std::vector<RtToken> tokens;
    for (const std::string& name : names) tokens.push_back(name.c_str());
    RiCurvesV(ri_basis(data.basis).matrix ? "cubic" : "linear", RtInt(data.counts.size()),
              const_cast<RtInt*>(data.counts.data()), "nonperiodic", RtInt(tokens.size()),
              tokens.data(), values.data());
}

}  // namespace

RiCurvesData curves_data(const lancret_curves& curves) {
    RiCurvesData out;
    out.basis = curves.basis;
    out.neighbours = int(curves.neighbours);
    if (curves.strands == 0) return out;
    const bool hermite = curves.basis == LANCRET_HERMITE;
    out.counts = integers(curves.counts, curves.strands);
    if (hermite) {
        for (RtInt& count : out.counts) count *= 2;
    }
    for (std::size_t t = 0; t < curves.times; ++t) {
        out.times.push_back(curves_at(curves, t));
    }
    join_widths(out);

    const std::size_t n = curves.strands;
    const auto add = [&](const char* declaration, const auto* values, std::size_t count) {
        if (!values || count == 0) return;
        Primvar primvar{declaration, {}, {}};
        if constexpr (std::is_same_v<decltype(values), const float*>) {
            primvar.floats = floats(values, count);
        } else {
            primvar.ints = integers(values, count);
        }
        out.primvars.push_back(std::move(primvar));
    };
    add("uniform integer id", curves.ids, n);
    add("uniform float[2] st", curves.root_uv, 2 * n);
    add("uniform float length", curves.lengths, n);
    add("uniform integer[] guides", curves.guides, curves.neighbours * n);
    add("uniform float[] weights", curves.weights, curves.neighbours * n);
    add("uniform float random", curves.random, n);
    add(hermite ? "varying float arc_length" : "vertex float arc_length",
        curves.arc_lengths, curves.points);
    return out;
}

void emit_curves(const RiCurvesData& data, const std::vector<RtFloat>& motion) {
    if (data.times.empty()) return;
    const RiCurveBasis basis = ri_basis(data.basis);
    RiAttributeBegin();
    if (basis.matrix) RiBasis(*basis.matrix, basis.step, *basis.matrix, basis.step);
    const bool moves = data.times.size() > 1;
    if (moves) {
        RiMotionBeginV(RtInt(motion.size()), const_cast<RtFloat*>(motion.data()));
    }
    for (const CurvesAtTime& time : data.times) emit_once(data, time);
    if (moves) RiMotionEnd();
    RiAttributeEnd();
}

}  // namespace lancret
