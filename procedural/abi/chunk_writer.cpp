#include "procedural/abi/chunk_writer.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "guides/base/hash.h"

namespace lancret::abi {

namespace {

constexpr std::uint64_t kRandomSalt = 0x72616e64;  // "rand"

/// The arrays of lancret_curves are const for sinks; those of lancret_chunk_write are the
/// host's to be written.
template <class T>
T* writable(const T* array) {
    return const_cast<T*>(array);
}

template <class T>
Buffer<T> temporary(Workspace& workspace, std::size_t size) {
    return Buffer<T>::over(workspace.take_array<T>(size), size);
}

void scale_points(std::span<Point4f> points, float scale) {
    if (scale == 1) return;
    for (Point4f& p : points) p = {p.x * scale, p.y * scale, p.z * scale, p.w * scale};
}

/// Writes one chunk to one set of arrays.
class ChunkWriter {
  public:
    ChunkWriter(const OpenGroom& groom, const ChunkBinding& chunk,
                const lancret_curves& out, Workspace& workspace)
        : groom_(groom),
          chunk_(chunk),
          request_(chunk.request),
          out_(out),
          workspace_(workspace),
          points_(sizes_of(chunk).points) {}

    void write(PosedBinding&& posed) {
        write_strands();
        if (out_.arc_lengths) write_arc_lengths();
        const bool still = request_.is_still() && first_time_has_all();
        for (std::size_t time = 0; time < request_.frames.size(); ++time) {
            if (still && time > 0) {
                copy_first_time(time);
                continue;
            }
            const auto pose = groom_.pose(request_.frames[time], request_.classes);
            write_time(posed.at(*pose), *pose, time);
        }
    }

  private:
    /// The host's array of a time, or temporary memory if expansion fills one that the
    /// host does not want.
    Buffer<Point4f> target(const float* const* arrays, std::size_t time) const {
        const float* array = arrays ? arrays[time] : nullptr;
        if (!array) return temporary<Point4f>(workspace_, points_);
        return Buffer<Point4f>::over(reinterpret_cast<Point4f*>(writable(array)),
                                     points_);
    }

    void write_time(const Binding& posed, const GuidePose& pose, std::size_t time) const {
        ExpandSettings settings = settings_of(groom_, request_);
        settings.segments = false;
        const bool hermite = request_.basis == LANCRET_HERMITE;
        settings.directions = !hermite && out_.tangents && out_.tangents[time];
        Curves curves;
        curves.points = target(out_.positions, time);
        if (hermite || settings.directions) curves.tangents = target(out_.tangents, time);
        if (settings.has_faces()) curves.normals = target(out_.normals, time);
        expand(posed, pose.classed, settings, curves);
        scale_points(curves.points.span(), float(request_.scale));
        if (hermite) scale_points(curves.tangents.span(), float(request_.scale));
    }

    /// Whether every array that is wanted at any time is wanted at the first.
    bool first_time_has_all() const {
        return (!out_.positions || out_.positions[0]) &&
               (!out_.tangents || out_.tangents[0]) && (!out_.normals || out_.normals[0]);
    }

    void copy_first_time(std::size_t time) const {
        for (const float* const* arrays : {out_.positions, out_.tangents, out_.normals}) {
            if (!arrays || !arrays[0] || !arrays[time] || arrays[0] == arrays[time]) {
                continue;
            }
            std::memcpy(writable(arrays[time]), arrays[0], points_ * sizeof(Point4f));
        }
    }

    /// Values per strand, which do not depend on time.
    void write_strands() const {
        const Binding& binding = chunk_.binding;
        const Roots& roots = binding.roots;
        const std::size_t strands = binding.size();
        const float scale = float(request_.scale);
        if (out_.counts) {
            lancret_u32* to = writable(out_.counts);
            for (const ChunkClass& alike : chunk_.classes) {
                to = std::fill_n(to, alike.strands, alike.points);
            }
        }
        if (out_.ids) {
            for (std::size_t i = 0; i < strands; ++i) {
                writable(out_.ids)[i] = roots.id(i);
            }
        }
        if (out_.root_uv) {
            for (std::size_t i = 0; i < strands; ++i) {
                const Vec2f uv = roots.uvs.empty() ? Vec2f(0, 0) : roots.uvs[i];
                writable(out_.root_uv)[2 * i] = uv.x();
                writable(out_.root_uv)[2 * i + 1] = uv.y();
            }
        }
        if (out_.lengths) {
            for (std::size_t i = 0; i < strands; ++i) {
                writable(out_.lengths)[i] = binding.lengths[i] * scale;
            }
        }
        if (out_.guides) std::ranges::copy(binding.guides, writable(out_.guides));
        if (out_.weights) std::ranges::copy(binding.weights, writable(out_.weights));
        if (out_.random) {
            const std::uint64_t seed = groom_.ready().groom.seed;
            for (std::size_t i = 0; i < strands; ++i) {
                writable(out_.random)[i] =
                    unit_float(hash_bits(seed, roots.id(i), kRandomSalt));
            }
        }
    }

    /// Arc length from the root, linear in the parameter of the curve and extrapolated to
    /// control points beyond its ends, so that the curve starts at 0 and ends at the
    /// strand's length.
    void write_arc_lengths() const {
        const BasisLayout& layout = layout_of(request_.curve);
        const float before = float(layout.before);
        const float* length = chunk_.binding.lengths.data();
        float* to = writable(out_.arc_lengths);
        for (const ChunkClass& alike : chunk_.classes) {
            for (std::uint32_t i = 0; i < alike.strands; ++i) {
                const float step = *length++ * float(request_.scale) /
                                   float(alike.intervals * layout.step);
                for (std::uint32_t j = 0; j < alike.points; ++j) {
                    *to++ = (float(j) - before) * step;
                }
            }
        }
    }

    const OpenGroom& groom_;
    const ChunkBinding& chunk_;
    const Request& request_;
    const lancret_curves& out_;
    Workspace& workspace_;
    std::size_t points_;
};

}  // namespace

void write_chunk(const OpenGroom& groom, const ChunkBinding& chunk,
                 const lancret_curves& out, Workspace& workspace) {
    ChunkWriter(groom, chunk, out, workspace).write(PosedBinding(groom, chunk));
}

void write_chunk(const OpenGroom& groom, ChunkBinding&& chunk, const lancret_curves& out,
                 Workspace& workspace) {
    ChunkWriter(groom, chunk, out, workspace)
        .write(PosedBinding(groom, std::move(chunk)));
}

ChunkArrays::ChunkArrays(const ChunkBinding& chunk, Workspace& workspace)
    : curves(sizes_of(chunk)) {
    const Request& request = chunk.request;
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
