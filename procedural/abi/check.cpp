// The entry point that checks one chunk.

#include <cmath>

#include "procedural/abi/chunk.h"
#include "procedural/check/check.h"
#include "procedural/check/chunks.h"
#include "procedural/chunk/box.h"

namespace lancret::abi {

namespace {

/// A NaN is the largest of all, and stays.
void keep_largest(double& largest, float value) {
    if (!(std::abs(double(value)) <= largest)) largest = std::abs(double(value));
}

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
    const CheckReport report = check(posed, pose->guides, pose->classed, curves,
                                     settings.blend, used.bind.length_scale, tolerances);
    lancret_check out{};
    out.strands = lancret_u32(report.strands.size());
    for (const StrandCheck& strand : report.strands) {
        out.failed += !report.passes(strand);
        keep_largest(out.orthogonality, strand.orthogonality);
        keep_largest(out.length_error, strand.length_error);
        keep_largest(out.curve_length_error, strand.emitted_length_error);
        keep_largest(out.distance, strand.distance);
    }
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
