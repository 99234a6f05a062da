// Chunks into a sink, or into the host's own memory; and the boxes that hold them.

#include <cstdint>
#include <new>
#include <utility>

#include "procedural/abi/box.h"
#include "procedural/abi/chunk.h"

using namespace lancret::abi;

lancret_status lancret_groom_get_chunk_box(const lancret_groom* groom, lancret_u32 chunk,
                                           const lancret_options* options, int kind,
                                           float box[6]) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(box, "box");
        require(kind == LANCRET_REACH || kind == LANCRET_TIGHT, "kind");
        const Eigen::AlignedBox3f found = bound_box(*groom->own, chunk, options, kind);
        for (int i = 0; i < 3; ++i) {
            box[i] = found.min()[i];
            box[3 + i] = found.max()[i];
        }
    });
}

lancret_status lancret_groom_expand_chunk(const lancret_groom* groom, lancret_u32 chunk,
                                          const lancret_options* options,
                                          lancret_sink sink, void* user) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(sink, "sink");
        const OpenGroom& own = *groom->own;
        ChunkBinding bound = bind_request(own, chunk, options);
        const WorkspaceLoan workspace(groom->context.workspaces);
        const ChunkArrays arrays(bound, *workspace);
        write_chunk(own, std::move(bound), arrays.curves, *workspace);
        lancret::stop_if_cancelled();
        lancret_status status = LANCRET_OK;
        call_host([&] { status = sink(user, &arrays.curves); });
        if (status != LANCRET_OK) throw SinkEnded{status};
    });
}

lancret_status lancret_chunk_open(const lancret_groom* groom, lancret_u32 chunk,
                                  const lancret_options* options, lancret_chunk** bound) {
    if (bound) *bound = nullptr;
    if (!groom || !bound) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        *bound = new lancret_chunk{groom->context, groom->own,
                                   bind_request(*groom->own, chunk, options)};
    });
}

lancret_status lancret_chunk_get_sizes(const lancret_chunk* bound,
                                       lancret_curves* sizes) {
    if (!bound) return LANCRET_BAD_CALL;
    return run(bound->context,
               [&] { write_sized(sizes, sizes_of(bound->own), "lancret_curves"); });
}

lancret_status lancret_chunk_write(const lancret_chunk* bound,
                                   const lancret_curves* buffers) {
    if (!bound) return LANCRET_BAD_CALL;
    return run(bound->context, [&] {
        const auto out = read_sized(buffers, "lancret_curves and its size");
        for (const float* const* arrays : {out.positions, out.tangents, out.normals}) {
            for (std::size_t t = 0; arrays && t < bound->own.request.frames.size(); ++t) {
                require(reinterpret_cast<std::uintptr_t>(arrays[t]) % 16 == 0,
                        "lancret_curves: an array is not aligned to 16 bytes");
            }
        }
        const WorkspaceLoan workspace(bound->context.workspaces);
        write_chunk(*bound->groom, bound->own, out, *workspace);
    });
}

void lancret_chunk_close(lancret_chunk* bound) { delete bound; }
