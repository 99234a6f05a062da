// Entry points for the figures of a chunk's strands, and for how binding went.

#include <algorithm>

#include "guides/base/errors.h"
#include "procedural/abi/chunk.h"
#include "procedural/bind/borders.h"
#include "procedural/check/values.h"

namespace lancret::abi {

namespace {

std::vector<float> region_values(const OpenGroom& groom, const ChunkBinding& chunk) {
    const PlacedGuides& placed = groom.ready().placed;
    if (!placed.grown.regions.map && placed.grown.regions.strands.empty()) {
        throw InputError(groom.ready().groom.name + ": has no regions");
    }
    const std::vector<std::uint32_t> regions =
        child_regions(placed.grown.regions, placed.grown.roots, chunk.binding.roots);
    return {regions.begin(), regions.end()};
}

std::vector<float> figures_of(const OpenGroom& groom, const ChunkBinding& chunk,
                              int figure, std::size_t time) {
    if (figure == LANCRET_REGION) return region_values(groom, chunk);
    const ExpandSettings settings = settings_of(groom, chunk.request);
    const auto pose = groom.pose(chunk.request.frames[time], chunk.request.classes);
    PosedBinding binding(groom, chunk);
    const Binding& posed = binding.at(*pose);
    const ClassedGuides& classed = pose->classed;
    switch (figure) {
        case LANCRET_LENGTH_ERROR: {
            const Curves curves = expand(posed, classed, settings);
            const float length_scale = groom.ready().groom.bind.length_scale;
            return length_error_values(check_strands({posed, pose->guides, classed,
                                                      curves, settings, length_scale}))
                .values;
        }
        case LANCRET_ORTHOGONALITY:
            return orthogonality_values(posed, classed, settings.blend).values;
        case LANCRET_CURVATURE:
            return curvature_values(posed, classed, settings.blend).values;
        default:
            if (!traits_of(settings.blend).has_torsion) {
                throw InputError(std::string(blend_name(settings.blend)) +
                                 ": has no torsion");
            }
            return torsion_values(posed, classed, settings.blend).values;
    }
}

lancret_chunk_info info_of(const ChunkBinding& chunk) {
    const BindReport& report = chunk.binding.report;
    lancret_chunk_info out{};
    out.strands = lancret_u32(chunk.binding.size());
    out.bytes = chunk.binding.bytes();
    for (const auto& [counter, field] : kBindCounterFields<lancret_chunk_info>) {
        out.*field = lancret_u32(report.*counter);
    }
    return out;
}

}  // namespace

}  // namespace lancret::abi

using namespace lancret::abi;

lancret_status lancret_chunk_get_info(const lancret_chunk* chunk,
                                      lancret_chunk_info* info) {
    if (!chunk) return LANCRET_BAD_CALL;
    return run(chunk->context, [&] {
        write_sized(info, info_of(chunk->bound),
                    "lancret_chunk_info: null, or invalid size");
    });
}

lancret_status lancret_chunk_get_figures(const lancret_chunk* chunk, int figure,
                                         std::size_t time, float* values) {
    if (!chunk) return LANCRET_BAD_CALL;
    return run(chunk->context, [&] {
        require(values, "values is null");
        require(figure >= LANCRET_LENGTH_ERROR && figure <= LANCRET_REGION,
                "unknown figure");
        require(time < chunk->bound.request.frames.size(), "time is out of range");
        std::ranges::copy(figures_of(*chunk->groom, chunk->bound, figure, time), values);
    });
}
