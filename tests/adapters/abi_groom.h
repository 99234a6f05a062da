#pragma once
// The groom that the adapters are tested with, and its curves through the C interface.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "procedural/lancret_procedural.h"
#include "tests/guides/base/temporary_folder.h"

namespace lancret {

/// A head of 40 guides and 300 strands.
struct MadeGroom : TemporaryFolder {
    std::string path =
        (*this / "made groom.toml").string();  // a name that must be quoted

    MadeGroom() {
        write_bytes(path,
                    "[guides]\nsegments = 6\n[guides.made]\nstrands = 40\n"
                    "[strands]\ncount = 300\n");
    }
};

/// A copy of a chunk.
struct AbiCurves {
    int basis = 0;
    lancret_u32 neighbours = 0;
    std::vector<lancret_u32> counts, ids, guides;
    /// [times][points * 4]
    std::vector<std::vector<float>> positions, tangents, normals;
    std::vector<float> root_uv, lengths, weights, arc_lengths, random;
};

inline lancret_status copy_curves(void* user, const lancret_curves* from) {
    AbiCurves& to = *static_cast<AbiCurves*>(user);
    const auto copy = [](const auto* values, std::size_t n) {
        return std::vector<std::decay_t<decltype(*values)>>(values,
                                                            values ? values + n : values);
    };
    const std::size_t strands = from->strands, points = from->points;
    to.basis = from->basis;
    to.neighbours = from->neighbours;
    to.counts = copy(from->counts, strands);
    for (std::size_t t = 0; t < from->times; ++t) {
        to.positions.push_back(copy(from->positions[t], 4 * points));
        if (from->tangents) to.tangents.push_back(copy(from->tangents[t], 4 * points));
        if (from->normals) to.normals.push_back(copy(from->normals[t], 4 * points));
    }
    to.ids = copy(from->ids, strands);
    to.root_uv = copy(from->root_uv, 2 * strands);
    to.lengths = copy(from->lengths, strands);
    to.guides = copy(from->guides, strands * from->neighbours);
    to.weights = copy(from->weights, strands * from->neighbours);
    to.arc_lengths = copy(from->arc_lengths, points);
    to.random = copy(from->random, strands);
    return LANCRET_OK;
}

/// A groom opened through the C interface.
struct AbiGroom {
    lancret_context* context = nullptr;
    lancret_groom* groom = nullptr;
    lancret_groom_info info{};

    explicit AbiGroom(const std::string& path, lancret_u32 chunk_strands = 0) {
        lancret_source source{};
        source.size = sizeof source;
        source.path = path.c_str();
        source.chunk_strands = chunk_strands;
        char error[512] = "";
        EXPECT_EQ(lancret_context_create(LANCRET_ABI_VERSION, nullptr, &context),
                  LANCRET_OK);
        EXPECT_EQ(lancret_groom_open(context, &source, &groom, error, sizeof error),
                  LANCRET_OK)
            << error;
        info.size = sizeof info;
        EXPECT_EQ(lancret_groom_get_info(groom, &info), LANCRET_OK);
    }
    ~AbiGroom() {
        lancret_groom_close(groom);
        lancret_context_destroy(context);
    }
    AbiGroom(const AbiGroom&) = delete;
    AbiGroom& operator=(const AbiGroom&) = delete;

    AbiCurves expand(lancret_u32 chunk, const lancret_options& options) const {
        AbiCurves out;
        EXPECT_EQ(lancret_groom_expand_chunk(groom, chunk, &options, copy_curves, &out),
                  LANCRET_OK);
        return out;
    }
};

inline lancret_options options_at(const std::vector<double>& times, int basis,
                                  lancret_u32 attributes = 0) {
    lancret_options out{};
    out.size = sizeof out;
    out.times = times.data();
    out.time_count = times.size();
    out.basis = basis;
    out.attributes = attributes;
    return out;
}

}  // namespace lancret
