// What a chunk is off by, and what a groom's blends are worth.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "procedural/abi/chunk.h"
#include "procedural/abi/source.h"
#include "procedural/check/check.h"
#include "procedural/check/chunks.h"
#include "procedural/evaluate/report.h"

namespace lancret::abi {

namespace {

lancret_check check_of(const OpenGroom& groom, std::uint32_t chunk,
                       const lancret_options* options) {
    const ChunkBinding bound = bind_request(groom, chunk, options);
    const Request& request = bound.request;
    const GroomSettings& own = groom.ready().groom;
    const auto pose = groom.pose(request.frames[0], request.classes);
    PosedBinding binding(groom, bound);
    const Binding& posed = binding.at(*pose);
    const ExpandSettings settings = settings_of(groom, request);
    Curves curves;
    expand(posed, pose->classed, settings, curves);
    CheckTolerances tolerances;
    tolerances.distance = request.max_error > 0 ? request.max_error : own.tolerance;
    const CheckReport report = check(posed, pose->guides, pose->classed, curves,
                                     settings.blend, own.bind.length_scale, tolerances);
    lancret_check out{};
    out.strands = lancret_u32(report.strands.size());
    for (const StrandCheck& strand : report.strands) {
        out.failed += !report.passes(strand);
        const auto largest = [](double& to, float value) {
            // A NaN is the worst.
            if (!(std::abs(double(value)) <= to)) to = std::abs(double(value));
        };
        largest(out.orthogonality, strand.orthogonality);
        largest(out.length_error, strand.length_error);
        largest(out.curve_length_error, strand.emitted_length_error);
        largest(out.distance, strand.distance);
    }
    Chunks all;
    all.children.resize(posed.size());
    std::iota(all.children.begin(), all.children.end(), 0u);
    all.first = {0, std::uint32_t(posed.size())};
    if (posed.size() > 0) {
        out.outside = lancret_u32(
            check_chunks(posed, pose->classed, curves, settings, all).outside);
    }
    return out;
}

std::string evaluation_text(lancret_context& context, const Source& source) {
    GroomSettings groom = read_groom_source(source.settings).groom;
    if (!groom.guides.number && !groom.guides.share) groom.guides.share = 0.05;
    std::vector<std::string> warnings;
    const EvaluationSubject subject = load_subject(groom, {}, warnings);
    for (const std::string& warning : warnings) {
        log(context, LANCRET_LOG_WARNING, warning);
    }
    const HoldOut taken = split_groom(groom, subject, std::nullopt);
    EvaluationReport report{.groom = groom.name,
                            .curl = {},
                            .seed = groom.seed,
                            .intervals = evaluation_intervals(taken.guides),
                            .blends = {}};
    const auto profiles = guide_profiles<float>(taken.guides, report.intervals);
    for (const BlendName& entry : kBlendNames) {
        stop_if_cancelled();
        report.blends.push_back(evaluate_blend(taken, profiles, entry.blend));
    }
    return evaluation_json(report, taken).dump(2);
}

}  // namespace

}  // namespace lancret::abi

using namespace lancret::abi;

lancret_status lancret_groom_check_chunk(const lancret_groom* groom, lancret_u32 chunk,
                                         const lancret_options* options,
                                         lancret_check* check) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(check, "lancret_check");
        write_sized(check, check_of(*groom->own, chunk, options), "lancret_check");
    });
}

lancret_status lancret_context_evaluate(lancret_context* context,
                                        const lancret_source* source,
                                        lancret_text_sink sink, void* user, char* error,
                                        std::size_t error_size) {
    copy_text("", error, error_size);
    if (!context) return LANCRET_BAD_CALL;
    std::string fault;
    const lancret_status status = run(
        *context,
        [&] {
            require(sink, "sink");
            const std::string text = evaluation_text(*context, read_source(source));
            call_host([&] { sink(user, text.c_str()); });
        },
        &fault);
    copy_text(fault, error, error_size);
    return status;
}
