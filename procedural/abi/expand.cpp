// Entry points that expand chunks, and the boxes of chunks.

#include <cstdint>
#include <utility>

#include "procedural/abi/box.h"
#include "procedural/abi/chunk_writer.h"

using namespace lancret::abi;

lancret_status lancret_groom_get_chunk_box(const lancret_groom* groom, lancret_u32 index,
                                           const lancret_options* options, int kind,
                                           float box[6]) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(box, "box is null");
        require(kind == LANCRET_REACH || kind == LANCRET_TIGHT, "unknown kind of box");
        const Eigen::AlignedBox3f out =
            box_of_chunk(*groom->shared, index, options, kind);
        for (int i = 0; i < 3; ++i) {
            box[i] = out.min()[i];
            box[3 + i] = out.max()[i];
        }
    });
}

lancret_status lancret_groom_expand_chunk(const lancret_groom* groom, lancret_u32 index,
                                          const lancret_options* options,
                                          lancret_curves_sink sink, void* user) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(sink, "sink is null");
        ChunkBinding chunk = bind_request(*groom->shared, index, options);
        const WorkspaceLoan workspace(groom->context.workspaces);
        const ChunkArrays arrays(chunk, *workspace);
        write_chunk(*groom->shared, std::move(chunk), arrays.curves, *workspace);
        lancret::stop_if_cancelled();
        lancret_status status = LANCRET_OK;
        call_host([&] { status = sink(user, &arrays.curves); });
        if (status != LANCRET_OK) throw SinkEnded{status};
    });
}

lancret_status lancret_chunk_open(const lancret_groom* groom, lancret_u32 index,
                                  const lancret_options* options, lancret_chunk** chunk) {
    if (chunk) *chunk = nullptr;
    if (!groom || !chunk) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        *chunk = new lancret_chunk{groom->context, groom->shared,
                                   bind_request(*groom->shared, index, options)};
    });
}

lancret_status lancret_chunk_get_sizes(const lancret_chunk* chunk,
                                       lancret_curves* sizes) {
    if (!chunk) return LANCRET_BAD_CALL;
    return run(chunk->context, [&] {
        write_sized(sizes, sizes_of(chunk->bound),
                    "lancret_curves: null, or invalid size");
    });
}

lancret_status lancret_chunk_write(const lancret_chunk* chunk,
                                   const lancret_curves* buffers) {
    if (!chunk) return LANCRET_BAD_CALL;
    return run(chunk->context, [&] {
        const auto out = read_sized(buffers, "lancret_curves: null, or invalid size");
        const std::size_t times = chunk->bound.request.frames.size();
        for (const float* const* arrays : {out.positions, out.tangents, out.normals}) {
            for (std::size_t t = 0; arrays && t < times; ++t) {
                require(reinterpret_cast<std::uintptr_t>(arrays[t]) % 16 == 0,
                        "lancret_curves: an array is not aligned to 16 bytes");
            }
        }
        const WorkspaceLoan workspace(chunk->context.workspaces);
        write_chunk(*chunk->groom, chunk->bound, out, *workspace);
    });
}

void lancret_chunk_close(lancret_chunk* chunk) { delete chunk; }
