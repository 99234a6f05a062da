#include "procedural/abi/chunk.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "guides/base/errors.h"
#include "guides/base/hash.h"
#include "procedural/expand/faces.h"

namespace lancret::abi {

namespace {

constexpr std::uint64_t kRandomSalt = 0x72616e64;  // "rand"

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

void scale_points(std::span<Point4f> points, float scale) {
    if (scale == 1) return;
    for (Point4f& p : points) p = {p.x * scale, p.y * scale, p.z * scale, p.w * scale};
}

void write_time(const OpenGroom& groom, const Request& request, std::size_t points,
                const Binding& posed, const GuidePose& pose, const lancret_curves& out,
                std::size_t time, Workspace& workspace) {
    ExpandSettings settings = settings_of(groom, request);
    settings.segments = false;
    const bool hermite = request.basis == LANCRET_HERMITE;
    settings.directions = !hermite && out.tangents && out.tangents[time];
    Curves curves;
    curves.points = target(out.positions, time, points, workspace);
    if (hermite || settings.directions) {
        curves.tangents = target(out.tangents, time, points, workspace);
    }
    if (settings.has_faces()) {
        curves.normals = target(out.normals, time, points, workspace);
    }
    expand(posed, pose.classed, settings, curves);
    scale_points(curves.points.span(), float(request.scale));
    if (hermite) scale_points(curves.tangents.span(), float(request.scale));
}

/// Whether what is asked for at any time is asked for at the first.
bool all_of_first(const lancret_curves& out) {
    return (!out.positions || out.positions[0]) && (!out.tangents || out.tangents[0]) &&
           (!out.normals || out.normals[0]);
}

/// What was written for the first time is there at another as well.
void copy_time(const lancret_curves& out, std::size_t points, std::size_t time) {
    for (const float* const* arrays : {out.positions, out.tangents, out.normals}) {
        if (!arrays || !arrays[0] || !arrays[time] || arrays[0] == arrays[time]) continue;
        std::memcpy(writable(arrays[time]), arrays[0], points * sizeof(Point4f));
    }
}

/// What is one a strand, whatever the time.
void write_strands(const OpenGroom& groom, const ChunkBinding& bound,
                   const lancret_curves& out) {
    const Binding& binding = bound.binding;
    const Roots& roots = binding.roots;
    const std::size_t strands = binding.size();
    const Request& request = bound.request;
    const float scale = float(request.scale);
    if (out.counts) {
        lancret_u32* to = writable(out.counts);
        for (const ChunkClass& own : bound.classes) {
            to = std::fill_n(to, own.strands, own.points);
        }
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
        const std::uint64_t seed = groom.ready().groom.seed;
        for (std::size_t i = 0; i < strands; ++i) {
            writable(out.random)[i] =
                unit_float(hash_bits(seed, roots.id(i), kRandomSalt));
        }
    }
}

/// Arc length from the root, linear in the curve's parameter: beyond its ends too, so
/// that the curve itself begins at 0 and ends at the strand's length.
void write_arc_lengths(const ChunkBinding& bound, float* to) {
    const Request& request = bound.request;
    const bool beyond =
        request.basis == LANCRET_BSPLINE || request.basis == LANCRET_CATMULL_ROM;
    const float before = beyond ? 1 : 0;
    const int in_interval = request.basis == LANCRET_BEZIER ? 3 : 1;
    const float* length = bound.binding.lengths.data();
    for (const ChunkClass& own : bound.classes) {
        for (std::uint32_t i = 0; i < own.strands; ++i) {
            const float step = *length++ * float(request.scale) /
                               float(own.intervals * std::uint32_t(in_interval));
            for (std::uint32_t j = 0; j < own.points; ++j) {
                *to++ = (float(j) - before) * step;
            }
        }
    }
}

}  // namespace

ExpandSettings settings_of(const OpenGroom& groom, const Request& request) {
    ExpandSettings out = groom.ready().groom.expand;
    out.basis = request.curve;
    out.faces = out.faces || request.wants(LANCRET_NORMALS);
    return out;
}

ChunkBinding bind_request(const OpenGroom& groom, std::uint32_t chunk,
                          const lancret_options* options) {
    ChunkBinding out{read_request(groom, chunk, options), {}, {}};
    const ReadyGroom& ready = groom.ready();
    const StrandClasses& classes = *out.request.classes;
    out.binding = bind_chunk(groom.groom(), chunk, out.request.density, classes);
    stop_if_cancelled();
    each_class(
        classes, out.binding, [&](std::size_t c, std::size_t first, std::size_t last) {
            const auto intervals = std::uint32_t(classes.counts[c]);
            out.classes.push_back({std::uint32_t(last - first), intervals,
                                   control_points_of(out.request.curve, intervals)});
        });
    if (out.request.wants(LANCRET_NORMALS) && out.binding.faces.empty()) {
        out.binding.faces =
            rest_faces(out.binding, ready.profiles, ready.groom.expand.blend);
    }
    return out;
}

lancret_curves sizes_of(const ChunkBinding& bound) {
    lancret_curves out{};
    out.size = sizeof out;
    out.basis = bound.request.basis;
    std::uint64_t points = 0;
    for (const ChunkClass& own : bound.classes) {
        points += std::uint64_t(own.strands) * own.points;
    }
    if (points > std::numeric_limits<lancret_u32>::max()) {
        throw InputError("a chunk has more than 2^32 points: make chunks smaller");
    }
    out.strands = lancret_u32(bound.binding.size());
    out.points = lancret_u32(points);
    out.times = lancret_u32(bound.request.frames.size());
    out.neighbours = lancret_u32(bound.binding.neighbours);
    return out;
}

PosedBinding::PosedBinding(const OpenGroom& groom, const ChunkBinding& bound)
    : still_(bound.binding) {
    if (!groom.times().moves()) return;
    rest_ = rest_places(bound.binding, groom.ready().source);
    moved_ = &copy_.emplace(bound.binding);
}

PosedBinding::PosedBinding(const OpenGroom& groom, ChunkBinding&& bound)
    : still_(bound.binding) {
    if (!groom.times().moves()) return;
    rest_ = rest_places(bound.binding, groom.ready().source);
    moved_ = &bound.binding;
}

const Binding& PosedBinding::at(const GuidePose& pose) {
    if (!moved_) return still_;
    pose_binding_on(*moved_, rest_, pose.scalp);
    return *moved_;
}

namespace {

void write_times(const OpenGroom& groom, const ChunkBinding& bound, PosedBinding&& posed,
                 const lancret_curves& out, Workspace& workspace) {
    const Request& request = bound.request;
    write_strands(groom, bound, out);
    if (out.arc_lengths) write_arc_lengths(bound, writable(out.arc_lengths));
    const std::size_t points = sizes_of(bound).points;
    const bool still = request.is_still() && all_of_first(out);
    for (std::size_t time = 0; time < request.frames.size(); ++time) {
        if (still && time > 0) {
            copy_time(out, points, time);
            continue;
        }
        const auto pose = groom.pose(request.frames[time], request.classes);
        write_time(groom, request, points, posed.at(*pose), *pose, out, time, workspace);
    }
}

}  // namespace

void write_chunk(const OpenGroom& groom, const ChunkBinding& bound,
                 const lancret_curves& out, Workspace& workspace) {
    write_times(groom, bound, PosedBinding(groom, bound), out, workspace);
}

void write_chunk(const OpenGroom& groom, ChunkBinding&& bound, const lancret_curves& out,
                 Workspace& workspace) {
    write_times(groom, bound, PosedBinding(groom, std::move(bound)), out, workspace);
}

ChunkArrays::ChunkArrays(const ChunkBinding& bound, Workspace& workspace)
    : curves(sizes_of(bound)) {
    const Request& request = bound.request;
    const std::size_t strands = curves.strands;
    const bool still = request.is_still();
    const auto each_time = [&](std::vector<const float*>& arrays) {
        arrays.push_back(workspace.take_array<float>(curves.points * std::size_t(4)));
        for (std::size_t t = 1; t < curves.times; ++t) {
            arrays.push_back(
                still ? arrays[0]
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
