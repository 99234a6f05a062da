#include <fmt/format.h>

#include <limits>

#include "guides/base/coordinates.h"
#include "guides/base/errors.h"
#include "procedural/abi/source.h"

namespace lancret::abi {

namespace {

std::vector<Vec3f> places(const float* from, std::size_t count, const char* what) {
    std::vector<Vec3f> out(count);
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = Vec3f(from[3 * i], from[3 * i + 1], from[3 * i + 2]);
        if (is_place(out[i])) continue;
        throw InputError(fmt::format("{}: point {} is at ({}, {}, {}), which is no place",
                                     what, i, out[i].x(), out[i].y(), out[i].z()));
    }
    return out;
}

}  // namespace

std::shared_ptr<const Strands> copied(const lancret_strands* given) {
    const auto in = read_sized(given, "lancret_strands and its size");
    require(in.strands > 0 && in.counts && in.points, "lancret_strands: arrays");
    require(in.basis >= LANCRET_LINEAR && in.basis <= LANCRET_CATMULL_ROM,
            "lancret_strands: basis");
    auto out = std::make_shared<Strands>();
    out->basis = in.basis == LANCRET_BSPLINE ? Basis::bspline : Basis::catmull_rom;
    out->first.reserve(std::size_t(in.strands) + 1);
    std::uint64_t points = 0;
    const lancret_u32 fewest = in.basis == LANCRET_BSPLINE ? 4 : 2;
    for (std::size_t i = 0; i < in.strands; ++i) {
        if (in.counts[i] < fewest) {
            throw InputError(
                fmt::format("strands: strand {} has {} points, expected {} or more", i,
                            in.counts[i], fewest));
        }
        points += in.counts[i];
        require(points <= std::numeric_limits<std::int32_t>::max(),
                "lancret_strands: more than 2^31 points");
        out->first.push_back(std::uint32_t(points));
    }
    out->points = places(in.points, points, "strands");
    return out;
}

std::shared_ptr<const TriangleMesh> copied(const lancret_mesh* given) {
    const auto in = read_sized(given, "lancret_mesh and its size");
    require(in.vertices > 0 && in.triangles > 0 && in.positions && in.corners,
            "lancret_mesh: arrays");
    auto out = std::make_shared<TriangleMesh>();
    out->positions = places(in.positions, in.vertices, "scalp");
    out->triangles.resize(in.triangles);
    for (std::size_t t = 0; t < in.triangles; ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t vertex = in.corners[3 * t + c];
            if (vertex >= in.vertices) {
                throw InputError(fmt::format(
                    "scalp: triangle {} has a corner at vertex {}, expected below {}", t,
                    vertex, in.vertices));
            }
            out->triangles[t][c] = vertex;
        }
    }
    if (!in.uvs) return out;
    out->uvs.resize(in.triangles);
    for (std::size_t t = 0; t < in.triangles; ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec2f uv(in.uvs[6 * t + 2 * c], in.uvs[6 * t + 2 * c + 1]);
            if (!uv.allFinite()) {
                throw InputError(
                    fmt::format("scalp: triangle {} has a UV that is not finite", t));
            }
            out->uvs[t][c] = uv;
        }
    }
    return out;
}

}  // namespace lancret::abi
