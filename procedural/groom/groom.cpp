#include "procedural/groom/groom.h"

#include <fmt/format.h>

#include <cmath>

#include "guides/base/coordinates.h"
#include "guides/base/errors.h"
#include "procedural/roots/density.h"

namespace lancret {

namespace {

constexpr std::uint32_t kDefaultGuides = 500;
constexpr std::uint32_t kDefaultChildren = 50000;
constexpr std::int64_t kMaxStrands = 100'000'000;
constexpr std::string_view kAxes[] = {"X", "Y", "Z"};
/// The bases that expansion emits.
constexpr Named<CurveBasis> kCurveBases[] = {
    {CurveBasis::bspline, layout_of(CurveBasis::bspline).name},
    {CurveBasis::hermite, layout_of(CurveBasis::hermite).name}};

void read_scene(const TomlTable& scene, SceneUnits& out) {
    if (const auto axis = scene.choice("up", kAxes)) {
        out.up = Vec3::Unit(int(*axis));
        out.gravity = -981 * out.up;
    }
    assign_if(out.metres_per_unit, scene.number("metres_per_unit", 1e-6, 1e6));
    assign_if(out.gravity, scene.vector("gravity"));
}

void read_made(const TomlTable& made, MadeGroomSettings& out) {
    assign_if(out.kind, made.choice("kind", kMadeKindNames));
    assign_if(out.strands, made.integer("strands", 1, 1'000'000));
    assign_if(out.seed, made.seed("seed"));
    assign_if(out.shortest, made.number("shortest", 0.1, 200));
    assign_if(out.longest, made.number("longest", 0.1, 200));
    if (out.shortest > out.longest) {
        made.fail(made.has("shortest") ? "shortest" : "longest",
                  fmt::format("the shortest strand, {} cm, must not be longer than the "
                              "longest, {} cm",
                              out.shortest, out.longest));
    }
    assign_if(out.curl_radius, made.number("curl_radius", 0, 10));
    assign_if(out.curl_wavelength, made.number("curl_wavelength", 0.1, 100));
    assign_if(out.frizz, made.number("frizz", 0, 10));
    assign_if(out.points, made.integer("points", 4, 1024));
    assign_if(out.phase_spread, made.number("phase_spread", 0, 1));
    assign_if(out.length_spread, made.number("length_spread", 0, 0.9));
}

void read_guides_table(const TomlTable& guides, GroomSettings& out) {
    assign_if(out.strands_file, guides.path("file"));
    if (guides.has("file") && guides.has("made")) {
        guides.fail("made", "set either 'file' or [guides.made], not both");
    }
    read_made(guides.table("made"), out.made);
    assign_if(out.basis, guides.choice("basis", kBasisNames));
    assign_if(out.guides.number, guides.integer("count", 1, kMaxStrands));
    assign_if(out.guides.share, guides.number("share", 0, 1));
    // An override of one replaces the other in the file.
    const bool new_count = guides.is_overridden("count"),
               new_share = guides.is_overridden("share");
    if (new_count && !new_share) out.guides.share.reset();
    if (new_share && !new_count) out.guides.number.reset();
    if (out.guides.number && out.guides.share) {
        guides.fail("share", "set either 'count' or 'share', not both");
    }
    assign_if(out.fit.segments, guides.integer("segments", 1, 200));
    assign_if(out.fit.fit_root_frame, guides.boolean("fit_root_frame"));
}

void read_strands(const TomlTable& strands, GroomSettings& out) {
    assign_if(out.strands, strands.integer("count", 1, kMaxStrands));
    assign_if(out.seed, strands.seed("seed"));
    assign_if(out.density, strands.number("density", kMinDensity, 1));
    std::vector<std::string_view> names;
    for (const BlendTraits& entry : blends()) names.push_back(entry.name);
    if (const auto blend = strands.choice("blend", names)) {
        out.expand.blend = blends()[*blend].blend;
    }
    assign_if(out.bind.neighbours, strands.integer("neighbours", 1, kMaxNeighbours));
    assign_if(out.bind.exponent, strands.number("exponent", 0, 16));
    assign_if(out.bind.facing, strands.boolean("facing"));
    assign_if(out.bind.max_distance, strands.number("max_distance", 1e-3, 1e6));
    if (const auto degrees = strands.number("max_angle_degrees", 0.1, 180)) {
        out.bind.max_angle = *degrees * kPi / 180;
    }
    assign_if(out.bind.length_scale, strands.number("length_scale", 0.001, 100));
    assign_if(out.tolerance, strands.number("tolerance", 1e-4, 10));
    if (const auto n = strands.integer("intervals", 1, 1000)) out.intervals = int(*n);
    assign_if(out.adapt, strands.boolean("adapt"));
    assign_if(out.expand.basis, strands.choice("curve", kCurveBases));
    assign_if(out.expand.shape, strands.choice("shape", kCurveShapeNames));
    if (out.expand.shape == CurveShape::ribbon &&
        out.expand.basis == CurveBasis::hermite) {
        strands.fail("shape", "shape 'ribbon' requires curve 'bspline'");
    }
}

void read_borders(const TomlTable& toml, GroomSettings& out) {
    const TomlTable regions = toml.table("regions");
    assign_if(out.regions.texture, regions.path("texture"));
    assign_if(out.regions.ids, regions.path("ids"));
    if (regions.has("texture") && regions.has("ids")) {
        regions.fail("ids", "set either 'texture' or 'ids', not both");
    }
    for (const TomlTable& parting : toml.tables("partings")) {
        auto points = parting.vectors("points", 2);
        if (!points) {
            parting.fail("points",
                         "a parting needs 'points', a list of at least two [x, y, z]");
        }
        for (Vec3& p : *points) {
            p *= out.scene.centimetres_per_unit();
            if (!(p.cwiseAbs().maxCoeff() <= kLargestCoordinate)) {
                parting.fail("points", fmt::format("'points' must be within {:.0e} cm",
                                                   kLargestCoordinate));
            }
        }
        out.partings.push_back(std::move(*points));
    }
}

}  // namespace

std::uint32_t GuideCount::of(std::size_t strands) const {
    const std::uint32_t all = std::uint32_t(strands);
    if (number) return std::min(*number, all);
    if (share) {
        return std::clamp<std::uint32_t>(std::uint32_t(std::lround(*share * all)), 1,
                                         all);
    }
    return std::min(kDefaultGuides, all);
}

std::uint32_t child_count(const GroomSettings& groom, bool on_scalp, std::size_t roots) {
    return groom.strands.value_or(on_scalp ? kDefaultChildren : std::uint32_t(roots));
}

GuideCount parse_guide_count(const std::string& text, const std::string& where) {
    GuideCount out;
    std::size_t used = 0;
    double value = 0;
    try {
        // Neither hexadecimal nor with an exponent.
        if (text.find_first_not_of("0123456789.%") == std::string::npos) {
            value = std::stod(text, &used);
        }
    } catch (const std::exception&) {
        used = 0;
    }
    const std::string unit = text.substr(used);
    if (used > 0 && unit == "%" && value > 0 && value <= 100) {
        out.share = value / 100;
    } else if (used > 0 && unit.empty() && value >= 1 && value <= double(kMaxStrands) &&
               value == std::floor(value)) {
        out.number = std::uint32_t(value);
    } else {
        throw InputError(fmt::format(
            "{}: invalid number of guides '{}': expected a whole number or a percentage "
            "such as 5%",
            where, text));
    }
    return out;
}

GroomSettings read_groom(const TomlTable& toml, std::string name) {
    GroomSettings out;
    out.name = std::move(name);
    read_scene(toml.table("scene"), out.scene);
    read_guides_table(toml.table("guides"), out);
    const TomlTable scalp = toml.table("scalp");
    assign_if(out.scalp_file, scalp.path("file"));
    assign_if(out.growth_distance, scalp.number("growth_distance", 1e-3, 1e4));
    read_strands(toml.table("strands"), out);
    read_borders(toml, out);
    const TomlTable width = toml.table("width");
    // The file has widths, curves have radii.
    if (const auto root = width.number("root", 0, 10)) {
        out.expand.taper.root = float(*root / 2);
    }
    if (const auto tip = width.number("tip", 0, 10)) {
        out.expand.taper.tip = float(*tip / 2);
    }
    return out;
}

}  // namespace lancret
