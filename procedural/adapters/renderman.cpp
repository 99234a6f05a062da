// RenderMan's DynamicLoad procedural. By its contract the renderer has a bound from the
// scene file, calls Subdivide from any thread, once, several times or never, when it
// reaches the bound, and calls Free when the procedural is no longer needed. The
// procedural of the scene file opens the groom and emits one procedural per chunk, each
// with a bound of its own. The procedural of a chunk emits curves.

#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

#include "procedural/adapters/renderman_curves.h"
#include "procedural/adapters/renderman_groom.h"
#include "procedural/adapters/renderman_parameters.h"

namespace lancret {
namespace {

/// The procedural of the scene file. Opens the groom when it is reached.
struct Root {
    RendermanParameters parameters;
    std::mutex mutex;
    std::shared_ptr<const SharedGroom> groom;

    std::shared_ptr<const SharedGroom> open() {
        const std::lock_guard lock(mutex);
        if (!groom) groom = std::make_shared<const SharedGroom>(parameters);
        return groom;
    }
};

/// The procedural of one chunk. May outlive its root.
struct Chunk {
    std::shared_ptr<const SharedGroom> groom;
    lancret_u32 index;
};

/// Passes the text of an exception to the renderer instead of throwing.
template <class F>
void guarded(RtInt code, F&& f) {
    try {
        f();
    } catch (const std::exception& error) {
        RiErrorPrint(code, kRiError, (std::string("lancret: ") + error.what()).c_str());
    } catch (...) {
        RiErrorPrint(kRiBug, kRiError, "lancret: unknown error");
    }
}

struct KeptCurves {
    RiCurvesData data;
    std::exception_ptr error;
};

/// Copies the curves. Ri is called only after Lancret has returned, since the renderer
/// may wait there for its own locks or tasks. Does not throw through Lancret.
lancret_status keep_curves(void* user, const lancret_curves* curves) {
    KeptCurves& kept = *static_cast<KeptCurves*>(user);
    try {
        kept.data = curves_data(*curves);
        return LANCRET_OK;
    } catch (...) {
        kept.error = std::current_exception();
        return LANCRET_FAILED;
    }
}

void subdivide_chunk(RtPointer data, RtFloat detail) {
    guarded(kRiSystem, [&] {
        const Chunk& chunk = *static_cast<const Chunk*>(data);
        const SharedGroom& groom = *chunk.groom;
        const lancret_options options = chunk_options(groom.parameters, detail);
        KeptCurves kept;
        const lancret_status status = lancret_groom_expand_chunk(
            groom.handle.get(), chunk.index, &options, keep_curves, &kept);
        groom.context->messages.print();
        if (kept.error) std::rethrow_exception(kept.error);
        expect_ok(status,
                  groom.parameters.file + ", chunk " + std::to_string(chunk.index),
                  groom.context->messages);
        emit_curves(kept.data, groom.parameters.motion);
    });
}

void free_chunk(RtPointer data) { delete static_cast<Chunk*>(data); }

void subdivide_root(Root& root) {
    const std::shared_ptr<const SharedGroom> groom = root.open();
    groom->context->messages.print();
    for (lancret_u32 i = 0; i < groom->info.chunks; ++i) {
        auto chunk = std::make_unique<Chunk>(Chunk{groom, i});
        RtBound bound;
        chunk_bound(*groom, i, bound);
        if (bound[0] > bound[1]) continue;  // the chunk grows no strand
        RiProcedural(chunk.release(), bound, subdivide_chunk, free_chunk);
    }
}

}  // namespace
}  // namespace lancret

extern "C" {

/// Null, with an error to the renderer, if the string is invalid.
[[gnu::visibility("default")]] RtPointer ConvertParameters(char* text) {
    lancret::Root* root = nullptr;
    lancret::guarded(lancret::kRiBadFile, [&] {
        auto read = std::make_unique<lancret::Root>();
        read->parameters = lancret::read_parameters(text ? text : "");
        root = read.release();
    });
    return root;
}

[[gnu::visibility("default")]] void Subdivide(RtPointer data, RtFloat) {
    if (!data) return;
    lancret::guarded(lancret::kRiBadFile, [&] {
        lancret::subdivide_root(*static_cast<lancret::Root*>(data));
    });
}

[[gnu::visibility("default")]] void Free(RtPointer data) {
    delete static_cast<lancret::Root*>(data);
}

}  // extern "C"
