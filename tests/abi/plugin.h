#pragma once
// Helpers of the tests of the C interface.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "procedural/lancret_procedural.h"

namespace lancret {

inline const std::string kSmallGroom =
    "[guides]\ncount = 60\nmade.strands = 200\n[strands]\ncount = 3000\nseed = 5\n";

struct CloseContext {
    void operator()(lancret_context* c) const { lancret_context_destroy(c); }
};
struct CloseGroom {
    void operator()(lancret_groom* g) const { lancret_groom_close(g); }
};
using ContextHandle = std::unique_ptr<lancret_context, CloseContext>;
using GroomHandle = std::unique_ptr<lancret_groom, CloseGroom>;

inline lancret_host make_host(int threads = 0) {
    lancret_host out{};
    out.size = sizeof out;
    out.threads = threads;
    return out;
}

inline ContextHandle make_context(const lancret_host* host = nullptr) {
    lancret_context* out = nullptr;
    EXPECT_EQ(lancret_context_create(LANCRET_ABI_VERSION, host, &out), LANCRET_OK);
    return ContextHandle(out);
}

/// `text` must outlive it.
inline lancret_source text_source(const std::string& text) {
    lancret_source out{};
    out.size = sizeof out;
    out.text = text.c_str();
    return out;
}

lancret_source text_source(std::string&&) = delete;

struct Opened {
    lancret_status status;
    GroomHandle groom;
    std::string error;
};

inline Opened open(lancret_context* context, const lancret_source& source) {
    lancret_groom* groom = nullptr;
    char error[512] = "unset";
    const lancret_status status =
        lancret_groom_open(context, &source, &groom, error, sizeof error);
    return {status, GroomHandle(groom), error};
}

inline GroomHandle opened(lancret_context* context, const std::string& text,
                          lancret_u32 chunk_strands = 0) {
    lancret_source source = text_source(text);
    source.chunk_strands = chunk_strands;
    Opened out = open(context, source);
    EXPECT_EQ(out.status, LANCRET_OK) << out.error;
    return std::move(out.groom);
}

inline lancret_groom_info info_of(const lancret_groom* groom) {
    lancret_groom_info out{};
    out.size = sizeof out;
    EXPECT_EQ(lancret_groom_get_info(groom, &out), LANCRET_OK);
    return out;
}

inline lancret_options make_options(int basis, lancret_u32 attributes = 0) {
    lancret_options out{};
    out.size = sizeof out;
    out.basis = basis;
    out.attributes = attributes;
    return out;
}

/// The arrays of one strand.
struct StrandArrays {
    std::vector<float> positions, tangents, normals, arc_lengths, weights;
    std::vector<lancret_u32> guides;
    float u = 0, v = 0, length = 0, random = 0;

    bool operator==(const StrandArrays&) const = default;
};
/// By id.
using AllStrands = std::map<lancret_u32, StrandArrays>;

inline lancret_status expand_with(
    const lancret_groom* groom, lancret_u32 chunk, const lancret_options& options,
    const std::function<lancret_status(const lancret_curves&)>& sink) {
    return lancret_groom_expand_chunk(
        groom, chunk, &options,
        [](void* user, const lancret_curves* curves) {
            return (*static_cast<decltype(&sink)>(user))(*curves);
        },
        const_cast<void*>(static_cast<const void*>(&sink)));
}

/// Adds the strands of a sink's curves at time `t`; requires ids.
inline void collect(const lancret_curves& c, std::size_t t, AllStrands& out) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < c.strands; ++i) {
        StrandArrays s;
        const auto rows = [&](const float* const* from, std::vector<float>& to) {
            if (from) to.assign(from[t] + 4 * first, from[t] + 4 * (first + c.counts[i]));
        };
        rows(c.positions, s.positions);
        rows(c.tangents, s.tangents);
        rows(c.normals, s.normals);
        if (c.arc_lengths) {
            s.arc_lengths.assign(c.arc_lengths + first,
                                 c.arc_lengths + first + c.counts[i]);
        }
        const std::size_t k = c.neighbours;
        if (c.guides) {
            s.guides.assign(c.guides + i * k, c.guides + (i + 1) * k);
            s.weights.assign(c.weights + i * k, c.weights + (i + 1) * k);
        }
        if (c.root_uv) s.u = c.root_uv[2 * i], s.v = c.root_uv[2 * i + 1];
        if (c.lengths) s.length = c.lengths[i];
        if (c.random) s.random = c.random[i];
        EXPECT_TRUE(out.emplace(c.ids[i], std::move(s)).second) << "duplicate id";
        first += c.counts[i];
    }
    EXPECT_EQ(first, c.points);
}

/// All strands of a groom; chunks are expanded in reverse order if `backwards`.
inline AllStrands expanded(const lancret_groom* groom, lancret_options options,
                           bool backwards = false, std::size_t time = 0) {
    options.attributes |= LANCRET_IDS;
    AllStrands out;
    const lancret_u32 chunks = info_of(groom).chunks;
    for (lancret_u32 i = 0; i < chunks; ++i) {
        const lancret_u32 chunk = backwards ? chunks - 1 - i : i;
        EXPECT_EQ(expand_with(groom, chunk, options,
                              [&](const lancret_curves& curves) {
                                  collect(curves, time, out);
                                  return LANCRET_OK;
                              }),
                  LANCRET_OK);
    }
    return out;
}

}  // namespace lancret
