#include "procedural/abi/request.h"

#include <algorithm>
#include <cmath>

#include "procedural/roots/density.h"

namespace lancret::abi {

namespace {

constexpr float kMinError = 1e-4f;  // cm, as for strands.tolerance in a groom's file
constexpr std::uint32_t kKnownAttributes =
    LANCRET_TANGENTS | LANCRET_NORMALS | LANCRET_IDS | LANCRET_ROOT_UV | LANCRET_LENGTHS |
    LANCRET_GUIDES | LANCRET_ARC_LENGTHS | LANCRET_RANDOM;

/// Both are false for a NaN.
bool is_share(double x) { return x >= 0 && x <= 1; }
bool is_amount(double x) { return x >= 0 && x <= 1e30; }

}  // namespace

Request read_request(const OpenGroom& groom, std::uint32_t index,
                     const lancret_options* options) {
    require(index < groom.chunked().chunks.size(), "chunk index is out of range");
    lancret_options in{};
    in.size = sizeof in;
    if (options) in = read_sized(options, "lancret_options: null, or invalid size");
    require(in.time_count <= kMaxTimes && (in.times || in.time_count == 0),
            "lancret_options: times is null, or time_count is above 256");
    require(in.basis >= LANCRET_LINEAR && in.basis <= LANCRET_HERMITE,
            "lancret_options: unknown basis");
    require(is_amount(in.max_error), "lancret_options: max_error is out of range");
    require(is_share(in.density), "lancret_options: density is not in [0, 1]");
    require(is_amount(in.pixels) && is_amount(in.strands_per_pixel),
            "lancret_options: pixels or strands_per_pixel is out of range");
    require(is_amount(in.unit) && (in.unit == 0 || in.unit >= 1e-6f),
            "lancret_options: unit is out of range");
    require((in.attributes & ~kKnownAttributes) == 0,
            "lancret_options: unknown attributes");

    Request out;
    const double scale = in.unit > 0 ? double(in.unit) : 1;
    for (std::size_t i = 0; i < in.time_count; ++i) {
        require(std::isfinite(in.times[i]), "lancret_options: a time is not finite");
        out.frames.push_back(groom.frame_at(in.times[i]));
    }
    if (out.frames.empty()) out.frames = {groom.frame_at(groom.times().first())};
    groom.expect_times(out.frames.size());
    constexpr CurveBasis kBases[] = {CurveBasis::linear, CurveBasis::bspline,
                                     CurveBasis::catmull_rom, CurveBasis::bezier,
                                     CurveBasis::hermite};
    out.basis = in.basis;
    out.curve = kBases[in.basis];
    out.max_error = float(in.max_error * scale);
    require(out.max_error == 0 || out.max_error >= kMinError,
            "lancret_options: max_error is below 1e-4 cm");
    const ReadyGroom& ready = groom.ready();
    out.density = in.density > 0 ? in.density : ready.groom.density;
    if (in.strands_per_pixel > 0) {
        out.density = std::min(
            out.density, lod_density(in.pixels, groom.chunked().chunks.of(index).size(),
                                     in.strands_per_pixel));
    }
    out.density = std::max(out.density, kMinDensity);
    out.attributes = in.attributes;
    out.classes = groom.classes(out.curve, out.max_error, out.wants(LANCRET_NORMALS));
    out.scale = 1 / scale;
    return out;
}

}  // namespace lancret::abi
