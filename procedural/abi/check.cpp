// The entry point that checks one chunk.

#include "procedural/abi/chunk.h"
#include "procedural/check/chunks.h"
#include "procedural/check/figures.h"
#include "procedural/chunk/box.h"

namespace lancret::abi {

namespace {

lancret_check check_of(const OpenGroom& groom, std::uint32_t index,
                       const lancret_options* options) {
    const ChunkBinding chunk = bind_request(groom, index, options);
    const Request& request = chunk.request;
    const GroomSettings& used = groom.ready().groom;
    const auto pose = groom.pose(request.frames[0], request.classes);
    PosedBinding binding(groom, chunk);
    const Binding& posed = binding.at(*pose);
    const ExpandSettings settings = settings_of(groom, request);
    Curves curves;
    expand(posed, pose->classed, settings, curves);
    CheckTolerances tolerances;
    tolerances.distance = request.max_error > 0 ? request.max_error : used.tolerance;
    const CheckReport report =
        check_strands({posed, pose->guides, pose->classed, curves, settings,
                       used.bind.length_scale, tolerances});
    lancret_check out{};
    out.strands = lancret_u32(report.strands.size());
    for (const StrandCheck& strand : report.strands) {
        out.failed += !report.passes(strand);
    }
    const StrandCheck largest = largest_figures(report);
    out.orthogonality = largest.orthogonality;
    out.length_error = largest.length_error;
    out.curve_length_error = largest.emitted_length_error;
    out.distance = largest.distance;
    const ChunkBox tight = chunk_box(posed, pose->classed, settings);
    out.outside = lancret_u32(strands_outside(curves, tight.box()));
    return out;
}

}  // namespace

}  // namespace lancret::abi

using namespace lancret::abi;

lancret_status lancret_groom_check_chunk(const lancret_groom* groom, lancret_u32 index,
                                         const lancret_options* options,
                                         lancret_check* check) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(check, "lancret_check is null");
        write_sized(check, check_of(*groom->shared, index, options),
                    "lancret_check: null, or invalid size");
    });
}
