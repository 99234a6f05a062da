// The entry point that evaluates the blends on a groom.

#include <nlohmann/json.hpp>

#include "guides/base/cancel.h"
#include "procedural/abi/handles.h"
#include "procedural/abi/source.h"
#include "procedural/evaluate/report.h"
#include "procedural/evaluate/subject.h"

namespace lancret::abi {

namespace {

std::string evaluation_text(lancret_context& context, const Source& source) {
    GroomSettings groom = read_groom(source).groom;
    if (!groom.guides.number && !groom.guides.share) groom.guides.share = 0.05;
    std::vector<std::string> warnings;
    const EvaluationSubject subject = load_subject(groom, {}, warnings);
    for (const std::string& warning : warnings) {
        log(context, LANCRET_LOG_WARNING, warning);
    }
    const HoldOut holdout = split_groom(groom, subject, std::nullopt);
    EvaluationReport report{.groom = groom.name,
                            .curl = {},
                            .seed = groom.seed,
                            .intervals = evaluation_intervals(holdout.guides),
                            .blends = {}};
    const auto profiles = guide_profiles<float>(holdout.guides, report.intervals);
    for (const BlendTraits& entry : blends()) {
        stop_if_cancelled();
        report.blends.push_back(evaluate_blend(holdout, profiles, entry.blend));
    }
    return evaluation_json(report, holdout).dump(2);
}

}  // namespace

}  // namespace lancret::abi

using namespace lancret::abi;

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
            require(sink, "sink is null");
            const std::string text = evaluation_text(*context, read_source(source));
            call_host([&] { sink(user, text.c_str()); });
        },
        &fault);
    copy_text(fault, error, error_size);
    return status;
}
