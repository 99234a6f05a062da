// What is known of a chunk's strands besides their curves.

#include <algorithm>

#include "guides/base/errors.h"
#include "procedural/abi/chunk.h"
#include "procedural/bind/borders.h"
#include "procedural/check/values.h"

namespace lancret::abi {

namespace {

std::vector<float> region_values(const OpenGroom& groom, const ChunkBinding& bound) {
    const PlacedGuides& source = groom.ready().source;
    if (!source.regions.map && source.regions.strands.empty()) {
        throw InputError(groom.ready().groom.name + ": has no regions");
    }
    const std::vector<std::uint32_t> regions =
        child_regions(source.regions, source.grown_roots, bound.binding.roots);
    return {regions.begin(), regions.end()};
}

std::vector<float> figures_of(const OpenGroom& groom, const ChunkBinding& bound,
                              int figure, std::size_t time) {
    if (figure == LANCRET_REGION) return region_values(groom, bound);
    const GroomSettings& own = groom.ready().groom;
    const ExpandSettings settings = settings_of(groom, bound.request);
    const auto pose = groom.pose(bound.request.frames[time], bound.request.classes);
    PosedBinding binding(groom, bound);
    const Binding& posed = binding.at(*pose);
    const ClassedGuides& classed = pose->classed;
    switch (figure) {
        case LANCRET_LENGTH_ERROR: {
            const Curves curves = expand(posed, classed, settings);
            return length_error_values(check(posed, pose->guides, classed, curves,
                                             settings.blend, own.bind.length_scale, {}))
                .values;
        }
        case LANCRET_ORTHOGONALITY:
            return orthogonality_values(posed, classed, settings.blend).values;
        case LANCRET_CURVATURE:
            return curvature_values(posed, classed, settings.blend).values;
        default:
            if (!has_torsion(settings.blend)) {
                throw InputError(std::string(blend_name(settings.blend)) +
                                 ": has no torsion");
            }
            return torsion_values(posed, classed, settings.blend).values;
    }
}

lancret_chunk_info info_of(const ChunkBinding& bound) {
    const BindReport& report = bound.binding.report;
    lancret_chunk_info out{};
    out.strands = lancret_u32(bound.binding.size());
    out.bytes = bound.binding.bytes();
    out.no_facing_guide = lancret_u32(report.no_facing_guide);
    out.no_guide_in_reach = lancret_u32(report.no_guide_in_reach);
    out.no_guide_in_sight = lancret_u32(report.no_guide_in_sight);
    out.no_guide_in_region = lancret_u32(report.no_guide_in_region);
    out.opposed_root_frames = lancret_u32(report.opposed_root_frames);
    out.straight_guides = lancret_u32(report.straight_guides);
    return out;
}

}  // namespace

}  // namespace lancret::abi

using namespace lancret::abi;

lancret_status lancret_chunk_get_info(const lancret_chunk* bound,
                                      lancret_chunk_info* info) {
    if (!bound) return LANCRET_BAD_CALL;
    return run(bound->context,
               [&] { write_sized(info, info_of(bound->own), "lancret_chunk_info"); });
}

lancret_status lancret_chunk_get_figures(const lancret_chunk* bound, int figure,
                                         std::size_t time, float* values) {
    if (!bound) return LANCRET_BAD_CALL;
    return run(bound->context, [&] {
        require(values, "values");
        require(figure >= LANCRET_LENGTH_ERROR && figure <= LANCRET_REGION, "figure");
        require(time < bound->own.request.frames.size(), "there is no such time");
        std::ranges::copy(figures_of(*bound->groom, bound->own, figure, time), values);
    });
}
