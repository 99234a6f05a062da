#include "procedural/check/chunks.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>

#include "guides/base/cancel.h"
#include "procedural/check/strand.h"

namespace lancret {

namespace {

constexpr int kPlacesPerSegment = 4;

/// The radius at t of a segment, where it is linear.
double radius_at(const EmittedStrand& strand, std::size_t segment, double t) {
    const BasisLayout& layout = layout_of(strand.basis);
    const std::size_t first = layout.step * segment + layout.before;
    return (1 - t) * strand.points[first].w + t * strand.points[first + layout.step].w;
}

/// The box of a strand's sampled places with their widths.
Eigen::AlignedBox3d measured_box(const EmittedStrand& strand) {
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

/// The reach_box of these children, as tight as a host could be given it: by the length
/// of the longest and the width of the widest of them.
Eigen::AlignedBox3f reach_of(const Binding& children, const ClassedGuides& guides,
                             const ExpandSettings& settings) {
    Eigen::AlignedBox3f roots;
    float longest = 0, width = 1;
    for (std::size_t i = 0; i < children.size(); ++i) {
        roots.extend(children.roots.positions[i]);
        longest = std::max(longest, children.lengths[i]);
        width = std::max(width, children.roots.width(i));
    }
    return reach_box(roots, longest, guides.classes.counts.back(), settings,
                     1 / double(width))
        .box();
}

/// The figures of one chunk.
struct ChunkFinding {
    std::size_t outside = 0, outside_reach = 0, unlike = 0;
    double box_volume = 0, strands_volume = 0;  ///< cm^3
};

ChunkFinding check_chunk(const Binding& binding, const ClassedGuides& guides,
                         const Curves& curves, const ExpandSettings& settings,
                         std::span<const std::uint32_t> children) {
    ChunkFinding out;
    const Binding chunk = picked(binding, children);
    const Eigen::AlignedBox3d box =
                                  chunk_box(chunk, guides, settings).box().cast<double>(),
                              reach = reach_of(chunk, guides, settings).cast<double>();
    Curves expanded;
    expand(chunk, guides, settings, expanded);
    Eigen::AlignedBox3d strands_box;
    for (std::size_t i = 0; i < children.size(); ++i) {
        const EmittedStrand strand = emitted_strand(expanded, i),
                            whole = emitted_strand(curves, children[i]);
        out.unlike += !same_bits(strand.points, whole.points) ||
                      !same_bits(strand.tangents, whole.tangents) ||
                      !same_bits(strand.normals, whole.normals);
        const Eigen::AlignedBox3d measured = measured_box(whole);
        out.outside += !box.contains(measured);
        out.outside_reach += !reach.contains(measured);
        strands_box.extend(measured);
    }
    out.box_volume = box.volume();
    out.strands_volume = strands_box.volume();
    return out;
}

}  // namespace

std::size_t strands_outside(const Curves& curves, const Eigen::AlignedBox3f& box) {
    using Range = tbb::blocked_range<std::size_t>;
    const Eigen::AlignedBox3d exact = box.cast<double>();
    return cancellable_reduce(
        Range(0, curves.strands), std::size_t(0),
        [&](const Range& range, std::size_t outside) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                outside += !exact.contains(measured_box(emitted_strand(curves, i)));
            }
            return outside;
        },
        std::plus<>());
}

ChunkCheck check_chunks(const Binding& binding, const ClassedGuides& guides,
                        const Curves& curves, const ExpandSettings& settings,
                        const Chunks& chunks) {
    std::vector<ChunkFinding> findings(chunks.size());
    cancellable_for(std::size_t(0), chunks.size(), [&](std::size_t c) {
        findings[c] = check_chunk(binding, guides, curves, settings, chunks.of(c));
    });
    ChunkCheck out;
    out.chunks = chunks.size();
    out.strands = chunks.children.size();
    double box_volume = 0, strands_volume = 0;
    for (const ChunkFinding& chunk : findings) {
        out.outside += chunk.outside;
        out.outside_reach += chunk.outside_reach;
        out.unlike += chunk.unlike;
        box_volume += chunk.box_volume;
        strands_volume += chunk.strands_volume;
        out.largest_ratio =
            std::max(out.largest_ratio, chunk.box_volume / chunk.strands_volume);
    }
    out.mean_ratio = chunks.size() > 0 ? box_volume / strands_volume : 1;
    return out;
}

ChunkCheck worst_of(const ChunkCheck& a, const ChunkCheck& b) {
    ChunkCheck out = b;
    out.outside = std::max(a.outside, b.outside);
    out.outside_reach = std::max(a.outside_reach, b.outside_reach);
    out.unlike = std::max(a.unlike, b.unlike);
    out.largest_ratio = std::max(a.largest_ratio, b.largest_ratio);
    out.mean_ratio = std::max(a.mean_ratio, b.mean_ratio);
    return out;
}

std::string chunks_line(const ChunkCheck& check) {
    return fmt::format(
        "chunks: {} of up to {} strands; strands outside the tight box {}, outside the "
        "reach {}, different from the whole groom {}; volume of the boxes over that of "
        "their strands {:.3f}, at most {:.3f}",
        check.chunks, kStrandsPerChunk, check.outside, check.outside_reach, check.unlike,
        check.mean_ratio, check.largest_ratio);
}

nlohmann::json chunks_json(const ChunkCheck& check) {
    return {
        {"count", check.chunks},
        {"pass", check.pass()},
        {"outside", check.outside},
        {"outside_reach", check.outside_reach},
        {"unlike", check.unlike},
        {"volume_over_true", {{"mean", check.mean_ratio}, {"max", check.largest_ratio}}}};
}

}  // namespace lancret
