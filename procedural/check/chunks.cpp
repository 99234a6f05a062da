#include "procedural/check/chunks.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>

#include "guides/base/cancel.h"
#include "procedural/check/strand.h"

namespace lancret {

namespace {

constexpr int kPlacesPerSegment = 4;

/// The radius at t of a segment, linear there.
double radius_at(const EmittedStrand& strand, std::size_t segment, double t) {
    const bool beyond =
        strand.basis == CurveBasis::bspline || strand.basis == CurveBasis::catmull_rom;
    const std::size_t step = strand.basis == CurveBasis::bezier ? 3 : 1;
    const std::size_t at = step * segment + (beyond ? 1 : 0);
    return (1 - t) * strand.points[at].w + t * strand.points[at + step].w;
}

/// What is seen of a strand: its places with their widths.
Eigen::AlignedBox3d seen_box(const EmittedStrand& strand) {
    Eigen::AlignedBox3d out;
    for (std::size_t j = 0; j < strand.segments(); ++j) {
        for (int q = 0; q <= kPlacesPerSegment; ++q) {
            const double t = double(q) / kPlacesPerSegment;
            const Vec3 p = strand.position(j, t),
                       radius = Vec3::Constant(radius_at(strand, j, t));
            out.extend(p - radius).extend(p + radius);
        }
    }
    return out;
}

bool same_bits(std::span<const Point4f> a, std::span<const Point4f> b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

/// What was found in one chunk.
struct Found {
    std::size_t outside = 0, unlike = 0;
    double volume = 0, seen = 0;
};

Found check_chunk(const Binding& binding, const ClassedGuides& guides,
                  const Curves& curves, const ExpandSettings& settings,
                  std::span<const std::uint32_t> children) {
    Found out;
    const Binding own = picked(binding, children);
    const Eigen::AlignedBox3d box = chunk_box(own, guides, settings).box().cast<double>();
    Curves alone;
    expand(own, guides, settings, alone);
    Eigen::AlignedBox3d seen;
    for (std::size_t i = 0; i < children.size(); ++i) {
        const EmittedStrand strand = emitted_strand(alone, i),
                            whole = emitted_strand(curves, children[i]);
        out.unlike += !same_bits(strand.points, whole.points) ||
                      !same_bits(strand.tangents, whole.tangents) ||
                      !same_bits(strand.normals, whole.normals);
        const Eigen::AlignedBox3d strand_box = seen_box(whole);
        out.outside += !box.contains(strand_box);
        seen.extend(strand_box);
    }
    out.volume = box.volume();
    out.seen = seen.volume();
    return out;
}

}  // namespace

ChunkCheck check_chunks(const Binding& binding, const ClassedGuides& guides,
                        const Curves& curves, const ExpandSettings& settings,
                        const Chunks& chunks) {
    std::vector<Found> found(chunks.size());
    cancellable_for(std::size_t(0), chunks.size(), [&](std::size_t c) {
        found[c] = check_chunk(binding, guides, curves, settings, chunks.of(c));
    });
    ChunkCheck out;
    out.chunks = chunks.size();
    out.strands = chunks.children.size();
    double volume = 0, seen = 0;
    for (const Found& chunk : found) {
        out.outside += chunk.outside;
        out.unlike += chunk.unlike;
        volume += chunk.volume;
        seen += chunk.seen;
        out.largest_ratio = std::max(out.largest_ratio, chunk.volume / chunk.seen);
    }
    out.mean_ratio = chunks.size() > 0 ? volume / seen : 1;
    return out;
}

std::size_t strands_outside(const Curves& curves, const Eigen::AlignedBox3f& box) {
    const Eigen::AlignedBox3d bounds = box.cast<double>();
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, curves.strands), std::size_t(0),
        [&](const tbb::blocked_range<std::size_t>& range, std::size_t outside) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                outside += !bounds.contains(seen_box(emitted_strand(curves, i)));
            }
            return outside;
        },
        std::plus<>());
}

ChunkCheck worst_of(const ChunkCheck& a, const ChunkCheck& b) {
    ChunkCheck out = b;
    out.outside = std::max(a.outside, b.outside);
    out.unlike = std::max(a.unlike, b.unlike);
    out.largest_ratio = std::max(a.largest_ratio, b.largest_ratio);
    out.mean_ratio = std::max(a.mean_ratio, b.mean_ratio);
    return out;
}

std::string chunks_line(const ChunkCheck& check) {
    return fmt::format(
        "chunks: {} of up to {} strands; outside their box {}, unlike the whole {}; box "
        "over what is seen, by volume {:.3f}, at most {:.3f}",
        check.chunks, kStrandsPerChunk, check.outside, check.unlike, check.mean_ratio,
        check.largest_ratio);
}

nlohmann::json chunks_json(const ChunkCheck& check) {
    return {
        {"count", check.chunks},
        {"pass", check.pass()},
        {"outside", check.outside},
        {"unlike", check.unlike},
        {"volume_over_true", {{"mean", check.mean_ratio}, {"max", check.largest_ratio}}}};
}

}  // namespace lancret
