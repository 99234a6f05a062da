// RenderMan's DynamicLoad procedural. Its contract, and how it is kept: the renderer
// knows a bound beforehand, from the scene file; it calls Subdivide when it reaches the
// bound, never or more than once, from any of its threads; it calls Free when it needs
// the procedural no more. The procedural of the scene file opens the groom and makes a
// procedural of each chunk, with a bound of its own, which makes curves.

#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

#include "procedural/adapters/renderman_curves.h"
#include "procedural/adapters/renderman_groom.h"
#include "procedural/adapters/renderman_parameters.h"

namespace lancret {
namespace {

/// The procedural of the scene file. The groom is opened when it is reached.
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

/// That of a chunk. It may outlive its root.
struct Chunk {
    std::shared_ptr<const SharedGroom> groom;
    lancret_u32 index;
};

/// Lets no exception out into the renderer, which prints its text.
template <class F>
void guarded(RtInt code, F&& f) {
    try {
        f();
    } catch (const std::exception& error) {
        RiErrorPrint(code, kRiError, (std::string("lancret: ") + error.what()).c_str());
    } catch (...) {
        RiErrorPrint(kRiBug, kRiError, "lancret: an unknown error");
    }
}

struct Kept {
    RiCurvesData data;
    std::exception_ptr error;
};

/// Converts, so that Ri is called when Lancret has taken its memory back, and outside of
/// its work: the renderer may wait for locks or work of its own there. Nothing is thrown
/// through Lancret.
lancret_status keep_curves(void* user, const lancret_curves* curves) {
    Kept& kept = *static_cast<Kept*>(user);
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
        Kept kept;
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
        chunk_box(*groom, i, bound);
        if (bound[0] > bound[1]) continue;  // none of its strands are grown
        RiProcedural(chunk.release(), bound, subdivide_chunk, free_chunk);
    }
}

}  // namespace
}  // namespace lancret

extern "C" {

/// Null where the string is wrong, which the renderer is told.
[[gnu::visibility("default")]] RtPointer ConvertParameters(char* text) {
    lancret::Root* root = nullptr;
    lancret::guarded(lancret::kRiBadFile, [&] {
        auto made = std::make_unique<lancret::Root>();
        made->parameters = lancret::read_parameters(text ? text : "");
        root = made.release();
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
