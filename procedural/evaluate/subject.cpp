#include "procedural/evaluate/subject.h"

#include <fmt/format.h>

#include "guides/base/errors.h"
#include "procedural/bind/partings.h"
#include "procedural/groom/placed_guides.h"

namespace lancret {

EvaluationSubject load_subject(const GroomSettings& groom,
                               const std::optional<CurlSettings>& curl,
                               std::vector<std::string>& warnings) {
    if (!groom.guides_file.empty() || groom.strands_file.extension() == ".h5") {
        throw InputError(fmt::format(
            "{}: contains guides only; an evaluation needs the strands of a dense groom",
            (groom.guides_file.empty() ? groom.strands_file : groom.guides_file)
                .string()));
    }
    EvaluationSubject out;
    out.scalp = load_scalp(groom);
    LoadedGroom loaded = load_groom(groom, warnings);
    if (!out.scalp && loaded.scalp) {
        out.scalp = make_scalp(std::move(*loaded.scalp));
        out.body = std::move(loaded.body);
    }
    if (!out.body && out.scalp) out.body = out.scalp->mesh;
    out.partings = groom_partings(groom, loaded.partings, out.scalp, warnings);
    if (groom.regions.any()) {
        warnings.push_back(
            fmt::format("{}: an evaluation ignores [regions]", groom.name));
    }
    out.strands = curl ? wrapped_in_curls(loaded.strands, *curl, groom.seed)
                       : std::move(loaded.strands);
    return out;
}

HoldOut split_groom(const GroomSettings& groom, const EvaluationSubject& subject,
                    std::optional<int> segments) {
    const Partings partings(subject.partings);
    return hold_out(subject.strands, subject.scalp ? &*subject.scalp : nullptr,
                    {.guides = groom.guides,
                     .segments = segments,
                     .bind = groom.bind,
                     .partings = partings.size() > 0 ? &partings : nullptr,
                     .seed = groom.seed},
                    groom.name);
}

}  // namespace lancret
