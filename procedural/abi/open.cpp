// Contexts and grooms: everything before the first strand.

#include <fmt/format.h>

#include <new>

#include "procedural/abi/handles.h"
#include "procedural/abi/source.h"
#include "procedural/groom/fit_report.h"

namespace lancret::abi {

namespace {

void log_warnings(const lancret_context& context, const PlacedGuides& source) {
    for (const std::string& warning : source.warnings) {
        log(context, LANCRET_LOG_WARNING, warning);
    }
    const std::string roots = roots_line(source);
    if (!roots.empty()) log(context, LANCRET_LOG_WARNING, roots);
}

std::shared_ptr<const OpenGroom> prepare(lancret_context& context, const Source& source) {
    const SourcedGroom sourced = read_groom_source(source.settings);
    const auto make = [&] {
        const auto stage = [&](const char* name) {
            stop_if_cancelled();
            log(context, LANCRET_LOG_INFO,
                fmt::format("{}: {}", sourced.groom.name, name));
        };
        const auto warn = [&context](const std::string& text) {
            log(context, LANCRET_LOG_WARNING, text);
        };
        auto out =
            std::make_shared<const OpenGroom>(sourced, source.chunk_strands, stage, warn);
        stop_if_cancelled();
        return out;
    };
    const auto key = key_of(source, sourced);
    auto out = key ? context.grooms.get(*key, make) : make();
    log_warnings(context, out->ready().source);
    return out;
}

int shape_of(const std::optional<CurveShape>& shape) {
    if (!shape) return LANCRET_ANY_SHAPE;
    return *shape == CurveShape::flat    ? LANCRET_FLAT
           : *shape == CurveShape::round ? LANCRET_ROUND
                                         : LANCRET_RIBBON;
}

lancret_info info_of(const OpenGroom& groom) {
    const ReadyGroom& ready = groom.ready();
    const SceneUnits& scene = ready.groom.scene;
    lancret_info out{};
    out.chunks = lancret_u32(groom.groom().chunks.size());
    out.strands = lancret_u32(groom.groom().places.size());
    out.guides = lancret_u32(ready.source.guides.size());
    out.segments = lancret_u32(ready.source.guides.segments);
    out.intervals = lancret_u32(ready.profiles.count);
    out.neighbours = lancret_u32(ready.binding.neighbours);
    if (groom.times().moves()) {
        out.first_frame = groom.times().first();
        out.last_frame = groom.times().last();
        out.frames = groom.times().info.frames;
    }
    const ExpandSettings& expand = ready.groom.expand;
    out.basis = expand.basis == CurveBasis::hermite ? LANCRET_HERMITE : LANCRET_BSPLINE;
    out.shape = shape_of(expand.shape);
    const Eigen::AlignedBox3f box = guide_box(ready);
    for (int i = 0; i < 3; ++i) {
        out.box[i] = box.min()[i];
        out.box[3 + i] = box.max()[i];
    }
    out.cm_per_unit = float(scene.centimetres_per_unit());
    for (int i = 0; i < 3; ++i) out.up[i] = float(scene.up[i]);
    out.load_seconds = ready.seconds.load;
    out.fit_seconds = ready.seconds.fit;
    out.bind_seconds = ready.seconds.bind;
    out.bytes = groom.bytes();
    return out;
}

}  // namespace

}  // namespace lancret::abi

using namespace lancret::abi;

const char* lancret_version(void) { return LANCRET_VERSION; }

int lancret_abi_version(void) { return LANCRET_ABI_VERSION; }

lancret_status lancret_context_create(int abi_version, const lancret_host* host,
                                      lancret_context** context) {
    if (!context) return LANCRET_BAD_CALL;
    *context = nullptr;
    if (abi_version != LANCRET_ABI_VERSION) return LANCRET_BAD_CALL;
    try {
        const lancret_host given =
            host ? read_sized(host, "lancret_host") : lancret_host{};
        if (!given.allocate != !given.release || given.threads < 0)
            return LANCRET_BAD_CALL;
        *context = new lancret_context(given);
        return LANCRET_OK;
    } catch (const BadCall&) {
        return LANCRET_BAD_CALL;
    } catch (const std::bad_alloc&) {
        return LANCRET_OUT_OF_MEMORY;
    } catch (...) {
        return LANCRET_FAILED;
    }
}

void lancret_context_destroy(lancret_context* context) { delete context; }

lancret_status lancret_groom_open(lancret_context* context, const lancret_source* source,
                                  lancret_groom** groom, char* error,
                                  std::size_t error_size) {
    if (error && error_size > 0) *error = 0;
    if (groom) *groom = nullptr;
    if (!context || !groom) return LANCRET_BAD_CALL;
    std::string text;
    const lancret_status status = run(
        *context,
        [&] {
            auto own = prepare(*context, read_source(source));
            *groom = new lancret_groom{*context, std::move(own)};
        },
        &text);
    copy_text(text, error, error_size);
    return status;
}

void lancret_groom_close(lancret_groom* groom) { delete groom; }

lancret_status lancret_groom_get_info(const lancret_groom* groom, lancret_info* info) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context,
               [&] { write_sized(info, info_of(*groom->own), "lancret_info"); });
}

lancret_status lancret_groom_get_guides(const lancret_groom* groom,
                                        lancret_guides* guides) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        const lancret::Guides& from = groom->own->ready().source.guides;
        const GuideArrays& arrays = groom->own->guide_arrays();
        static_assert(sizeof(lancret::Vec3) == 3 * sizeof(double));
        lancret_guides out{};
        out.guides = lancret_u32(from.size());
        out.segments = lancret_u32(from.segments);
        out.root_positions = from.root_positions.data()->data();
        out.root_frames = arrays.root_frames.data();
        out.segment_lengths = from.segment_lengths.data();
        out.curvatures = from.curvatures.data()->data();
        out.fit_rms = arrays.fit_rms.empty() ? nullptr : arrays.fit_rms.data();
        write_sized(guides, out, "lancret_guides");
    });
}
