#include "procedural/abi/chunk.h"

#include <algorithm>
#include <cstring>

#include "guides/hash.h"
#include "procedural/faces.h"

namespace lancret::abi {

namespace {

constexpr std::uint64_t kRandomSalt = 0x72616e64;  // "rand"

CurveBasis basis_of(const Request& request) {
    return request.basis == LANCRET_HERMITE ? CurveBasis::hermite : CurveBasis::bspline;
}

/// The library's arrays are const to those who only read them.
template <class T>
T* writable(const T* array) {
    return const_cast<T*>(array);
}

template <class T>
Buffer<T> over(Workspace& workspace, std::size_t size) {
    return Buffer<T>::over(workspace.take_array<T>(size), size);
}

/// The array of a time, or memory for one that is not wanted but is written.
Buffer<Point4f> target(const float* const* arrays, std::size_t time, std::size_t size,
                       Workspace& workspace) {
    const float* wanted = arrays ? arrays[time] : nullptr;
    if (!wanted) return over<Point4f>(workspace, size);
    return Buffer<Point4f>::over(reinterpret_cast<Point4f*>(writable(wanted)), size);
}

/// The direction of the curve where each control point has the most weight.
void bspline_tangents(const Curves& curves, float* tangents) {
    auto* to = reinterpret_cast<Point4f*>(tangents);
    const std::size_t m = curves.points_per_strand;
    for (std::size_t i = 0; i < curves.points.size(); i += m) {
        for (std::size_t j = 0; j < m; ++j) {
            const std::size_t at = i + std::clamp<std::size_t>(j, 1, m - 2);
            const Vec3f along = curves.points[at + 1].xyz() - curves.points[at - 1].xyz();
            const Vec3f unit = along.normalized();
            to[i + j] = {unit.x(), unit.y(), unit.z(), 0};
        }
    }
}

void scale_points(std::span<Point4f> points, float scale) {
    if (scale == 1) return;
    for (Point4f& p : points) p = {p.x * scale, p.y * scale, p.z * scale, p.w * scale};
}

void write_time(const Prepared& groom, const BoundChunk& bound, const lancret_curves& out,
                std::size_t time, Workspace& workspace) {
    const Request& request = bound.request;
    const std::size_t points = sizes_of(bound).points;
    const auto settings = settings_of(groom, request);
    const bool hermite = request.basis == LANCRET_HERMITE;
    Curves curves;
    curves.points = target(out.positions, time, points, workspace);
    if (hermite) curves.tangents = target(out.tangents, time, points, workspace);
    if (settings.has_faces())
        curves.normals = target(out.normals, time, points, workspace);
    curves.segments =
        over<std::uint32_t>(workspace, bound.binding.size() * request.intervals);
    const auto pose = guide_pose(groom, request);
    expand(bound.binding, pose->profiles, pose->kernel, settings, curves);
    stop_if_cancelled();
    if (!hermite && out.tangents && out.tangents[time]) {
        bspline_tangents(curves, writable(out.tangents[time]));
    }
    scale_points(curves.points.span(), float(request.scale));
    scale_points(curves.tangents.span(), float(request.scale));
}

/// What is one a strand, whatever the time.
void write_strands(const Prepared& groom, const BoundChunk& bound,
                   const lancret_curves& out) {
    const Binding& binding = bound.binding;
    const Roots& roots = binding.roots;
    const std::size_t strands = binding.size();
    const Request& request = bound.request;
    const float scale = float(request.scale);
    if (out.counts) {
        const lancret_curves sizes = sizes_of(bound);
        std::fill_n(writable(out.counts), strands,
                    sizes.points / std::max(1u, sizes.strands));
    }
    if (out.ids) {
        for (std::size_t i = 0; i < strands; ++i) writable(out.ids)[i] = roots.id(i);
    }
    if (out.root_uv) {
        for (std::size_t i = 0; i < strands; ++i) {
            const Vec2f uv = roots.uvs.empty() ? Vec2f(0, 0) : roots.uvs[i];
            writable(out.root_uv)[2 * i] = uv.x();
            writable(out.root_uv)[2 * i + 1] = uv.y();
        }
    }
    if (out.lengths) {
        for (std::size_t i = 0; i < strands; ++i) {
            writable(out.lengths)[i] = binding.lengths[i] * scale;
        }
    }
    if (out.guides) std::ranges::copy(binding.guides, writable(out.guides));
    if (out.weights) std::ranges::copy(binding.weights, writable(out.weights));
    if (out.random) {
        const std::uint64_t seed = groom.generator().groom.seed;
        for (std::size_t i = 0; i < strands; ++i) {
            writable(out.random)[i] =
                unit_float(hash_bits(seed, roots.id(i), kRandomSalt));
        }
    }
}

/// Arc length from the root, linear in the curve's parameter: beyond its ends too, so
/// that the curve itself begins at 0 and ends at the strand's length.
void write_arc_lengths(const BoundChunk& bound, float* to) {
    const Request& request = bound.request;
    const lancret_curves sizes = sizes_of(bound);
    if (sizes.strands == 0) return;
    const std::size_t m = sizes.points / sizes.strands;
    const float before = request.basis == LANCRET_BSPLINE ? 1 : 0;
    for (std::size_t i = 0; i < sizes.strands; ++i) {
        const float step =
            bound.binding.lengths[i] * float(request.scale) / float(request.intervals);
        for (std::size_t j = 0; j < m; ++j) *to++ = (float(j) - before) * step;
    }
}

}  // namespace

ExpandSettings settings_of(const Prepared& groom, const Request& request) {
    ExpandSettings out = groom.generator().groom.expand;
    out.basis = basis_of(request);
    out.faces = out.faces || request.wants(LANCRET_NORMALS);
    return out;
}

std::shared_ptr<const GuidePose> guide_pose(const Prepared& groom,
                                            const Request& request) {
    return groom.poses.get(request.intervals, [&] {
        const Generator& generator = groom.generator();
        auto made = std::make_shared<GuidePose>();
        made->profiles =
            guide_profiles<float>(generator.source.guides, request.intervals);
        made->kernel = kernel_guides(made->profiles, generator.binding.guide_normals,
                                     generator.groom.expand.blend);
        return made;
    });
}

BoundChunk bind_request(const Prepared& groom, std::uint32_t chunk,
                        const lancret_options* options) {
    BoundChunk out{read_request(groom, chunk, options), {}};
    const Generator& generator = groom.generator();
    out.binding = bind_chunk(groom.groom, chunk, out.request.density);
    stop_if_cancelled();
    if (out.request.wants(LANCRET_NORMALS) && out.binding.faces.empty()) {
        out.binding.faces =
            rest_faces(out.binding, generator.profiles, generator.groom.expand.blend);
    }
    return out;
}

lancret_curves sizes_of(const BoundChunk& bound) {
    lancret_curves out{};
    const Request& request = bound.request;
    out.size = sizeof out;
    out.basis = request.basis;
    out.strands = lancret_u32(bound.binding.size());
    out.points = out.strands *
                 control_points_of(basis_of(request), std::uint32_t(request.intervals));
    out.times = lancret_u32(request.times.size());
    out.neighbours = lancret_u32(bound.binding.neighbours);
    return out;
}

void write_chunk(const Prepared& groom, const BoundChunk& bound,
                 const lancret_curves& out, Workspace& workspace) {
    write_strands(groom, bound, out);
    if (out.arc_lengths) write_arc_lengths(bound, writable(out.arc_lengths));
    for (std::size_t time = 0; time < bound.request.times.size(); ++time) {
        write_time(groom, bound, out, time, workspace);
    }
}

ChunkArrays::ChunkArrays(const BoundChunk& bound, bool one_time, Workspace& workspace)
    : curves(sizes_of(bound)) {
    const Request& request = bound.request;
    const std::size_t strands = curves.strands;
    const auto each_time = [&](std::vector<const float*>& arrays) {
        arrays.push_back(workspace.take_array<float>(curves.points * std::size_t(4)));
        for (std::size_t t = 1; t < curves.times; ++t) {
            arrays.push_back(
                one_time ? arrays[0]
                         : workspace.take_array<float>(curves.points * std::size_t(4)));
        }
        return arrays.data();
    };
    curves.counts = workspace.take_array<lancret_u32>(strands);
    curves.positions = each_time(positions);
    if (request.wants(LANCRET_TANGENTS) || request.basis == LANCRET_HERMITE) {
        curves.tangents = each_time(tangents);
    }
    if (request.wants(LANCRET_NORMALS)) curves.normals = each_time(normals);
    if (request.wants(LANCRET_IDS)) {
        curves.ids = workspace.take_array<lancret_u32>(strands);
    }
    if (request.wants(LANCRET_ROOT_UV)) {
        curves.root_uv = workspace.take_array<float>(2 * strands);
    }
    if (request.wants(LANCRET_LENGTHS)) {
        curves.lengths = workspace.take_array<float>(strands);
    }
    if (request.wants(LANCRET_GUIDES)) {
        curves.guides = workspace.take_array<lancret_u32>(strands * curves.neighbours);
        curves.weights = workspace.take_array<float>(strands * curves.neighbours);
    }
    if (request.wants(LANCRET_ARC_LENGTHS)) {
        curves.arc_lengths = workspace.take_array<float>(curves.points);
    }
    if (request.wants(LANCRET_RANDOM)) {
        curves.random = workspace.take_array<float>(strands);
    }
}

}  // namespace lancret::abi
