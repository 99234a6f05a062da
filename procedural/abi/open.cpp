// Entry points that create contexts and open grooms.

#include <fmt/format.h>

#include <new>

#include "guides/base/cancel.h"
#include "procedural/abi/handles.h"
#include "procedural/abi/source.h"
#include "procedural/groom/fit_report.h"

namespace lancret::abi {

namespace {

std::shared_ptr<const OpenGroom> open_groom(lancret_context& context,
                                            const Source& source) {
    const SourcedGroom sourced = read_groom(source);
    const auto warn = [&context](const std::string& text) {
        log(context, LANCRET_LOG_WARNING, text);
    };
    const auto make = [&] {
        const auto stage = [&](GroomStage next) {
            stop_if_cancelled();
            log(context, LANCRET_LOG_INFO,
                fmt::format("{}: {}", sourced.groom.name, stage_name(next)));
        };
        auto out =
            std::make_shared<const OpenGroom>(sourced, source.chunk_strands, stage, warn);
        stop_if_cancelled();
        return out;
    };
    const auto key = key_of(source, sourced);
    auto out = key ? context.grooms.get(*key, make) : make();
    for (const std::string& warning : warning_lines(out->ready().placed)) warn(warning);
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
            host ? read_sized(host, "lancret_host: invalid size") : lancret_host{};
        if (!given.allocate != !given.release || given.threads < 0) {
            return LANCRET_BAD_CALL;
        }
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
    copy_text("", error, error_size);
    if (groom) *groom = nullptr;
    if (!context || !groom) return LANCRET_BAD_CALL;
    std::string fault;
    const lancret_status status = run(
        *context,
        [&] {
            auto shared = open_groom(*context, read_source(source));
            *groom = new lancret_groom{*context, std::move(shared)};
        },
        &fault);
    copy_text(fault, error, error_size);
    return status;
}

void lancret_groom_close(lancret_groom* groom) { delete groom; }
