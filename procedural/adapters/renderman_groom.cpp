#include "procedural/adapters/renderman_groom.h"

#include <algorithm>
#include <future>
#include <stdexcept>
#include <utility>

namespace lancret {
namespace {

void keep_message(void* user, int level, const char* text) {
    const RtInt severity = level == LANCRET_LOG_ERROR     ? kRiError
                           : level == LANCRET_LOG_WARNING ? kRiWarning
                                                          : kRiInfo;
    static_cast<Messages*>(user)->add(severity, text);
}

/// The context that all procedurals of the process share, one per number of threads.
/// RenderMan creates a procedural for each instance and has no place for shared state.
std::shared_ptr<Context> shared_context(int threads) {
    static std::mutex mutex;
    static std::map<int, std::weak_ptr<Context>> contexts;
    const std::lock_guard lock(mutex);
    std::shared_ptr<Context> out = contexts[threads].lock();
    if (!out) contexts[threads] = out = std::make_shared<Context>(threads);
    return out;
}

}  // namespace

void Messages::add(RtInt severity, std::string text) {
    const std::lock_guard lock(mutex_);
    if (severity == kRiError) {
        errors_[std::this_thread::get_id()] = std::move(text);
    } else {
        texts_.emplace_back(severity, std::move(text));
    }
}

std::string Messages::take_error() {
    const std::lock_guard lock(mutex_);
    auto error = errors_.extract(std::this_thread::get_id());
    return error ? std::move(error.mapped()) : std::string();
}

void Messages::print() {
    std::vector<std::pair<RtInt, std::string>> texts;
    {
        const std::lock_guard lock(mutex_);
        texts.swap(texts_);
    }
    for (const auto& [severity, text] : texts) {
        RiErrorPrint(kRiSystem, severity, ("lancret: " + text).c_str());
    }
}

void expect_ok(lancret_status status, const std::string& what, Messages& messages) {
    constexpr const char* kNames[] = {
        "", "bad input", "invalid call", "out of memory", "cancelled", "internal error"};
    if (status == LANCRET_OK) return;
    const bool known = status > 0 && status < int(std::size(kNames));
    std::string text = what + ": " + (known ? kNames[status] : "unknown status");
    if (const std::string error = messages.take_error(); !error.empty()) {
        text += ", " + error;
    }
    throw std::runtime_error(text);
}

Context::Context(int threads) {
    lancret_host host{};
    host.size = sizeof host;
    host.user = &messages;
    host.log = keep_message;
    host.threads = threads;
    expect_ok(lancret_context_create(LANCRET_ABI_VERSION, &host, &handle),
              "lancret_context_create", messages);
}

SharedGroom::SharedGroom(RendermanParameters given)
    : parameters(std::move(given)),
      context(shared_context(parameters.threads)),
      handle(nullptr, lancret_groom_close) {
    std::vector<lancret_parameter> values;
    for (const GroomValue& value : parameters.values) {
        values.push_back({value.name.c_str(),
                          value.is_text ? value.text.c_str() : nullptr, value.number});
    }
    lancret_source source{};
    source.size = sizeof source;
    source.path = parameters.file.c_str();
    source.parameters = values.data();
    source.parameter_count = values.size();
    source.chunk_strands = parameters.chunk_strands;
    // On a thread of its own. The caller holds a lock; if it waited for Lancret's TBB
    // tasks itself, it might execute another Subdivide of the renderer, which waits for
    // that lock.
    char error[1024] = "";
    lancret_groom* opened = nullptr;
    const lancret_status status =
        std::async(std::launch::async, [&] {
            const lancret_status out = lancret_groom_open(context->handle, &source,
                                                          &opened, error, sizeof error);
            context->messages.take_error();  // the same text, logged
            return out;
        }).get();
    handle.reset(opened);
    if (status != LANCRET_OK && error[0] != '\0') throw std::runtime_error(error);
    expect_ok(status, parameters.file, context->messages);
    info.size = sizeof info;
    expect_ok(lancret_groom_get_info(handle.get(), &info), "lancret_groom_get_info",
              context->messages);
}

lancret_options chunk_options(const RendermanParameters& parameters, RtFloat detail) {
    lancret_options out{};
    out.size = sizeof out;
    out.times = parameters.times.data();
    out.time_count = parameters.times.size();
    out.basis = parameters.basis;
    out.max_error = parameters.max_error;
    out.density = parameters.density;
    out.attributes = parameters.attributes;
    out.unit = parameters.unit;
    if (parameters.strands_per_pixel > 0 && detail < kNoDetail) {
        // Density is strands_per_pixel * pixels / strands of the chunk, which has at most
        // chunk_strands: with these pixels or more it is at least min_density.
        out.strands_per_pixel = parameters.strands_per_pixel;
        out.pixels =
            std::max(double(detail), parameters.min_density * parameters.chunk_strands /
                                         parameters.strands_per_pixel);
    }
    return out;
}

void chunk_bound(const SharedGroom& groom, lancret_u32 chunk, RtBound bound) {
    const RendermanParameters& parameters = groom.parameters;
    const std::string what =
        parameters.file + ", bound of chunk " + std::to_string(chunk);
    float box[6];
    const lancret_options full = chunk_options(parameters, kNoDetail);
    expect_ok(lancret_groom_get_chunk_box(groom.handle.get(), chunk, &full,
                                          parameters.bound, box),
              what, groom.context->messages);
    if (parameters.strands_per_pixel > 0) {
        // At the lowest density, where strands are widest.
        float widest[6];
        const lancret_options sparse = chunk_options(parameters, 0);
        expect_ok(lancret_groom_get_chunk_box(groom.handle.get(), chunk, &sparse,
                                              LANCRET_REACH, widest),
                  what, groom.context->messages);
        for (int a = 0; a < 3; ++a) {
            box[a] = std::min(box[a], widest[a]);
            box[a + 3] = std::max(box[a + 3], widest[a + 3]);
        }
    }
    for (int a = 0; a < 3; ++a) {
        bound[2 * a] = box[a];
        bound[2 * a + 1] = box[a + 3];
    }
}

}  // namespace lancret
