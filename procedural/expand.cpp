#include "procedural/expand.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <limits>
#include <stdexcept>
#include <type_traits>

#include "procedural/faces.h"
#include "procedural/kernels/strand_kernels.h"

namespace lancret {

namespace {

/// Output of this size does not stay in a cache until somebody reads it: measured.
constexpr std::size_t kPastCaches = std::size_t(8) << 20;

/// An empty frame for the strands of `binding`, in the buffers of `out` where they fit.
void make_room(const Binding& binding, std::size_t intervals,
               const ExpandSettings& settings, Curves& out) {
    const std::size_t strands = binding.size();
    out.basis = settings.basis;
    out.shape = settings.shape.value_or(CurveShape::flat);
    out.strands = std::uint32_t(strands);
    out.ids = binding.roots.ids;
    out.segments_per_strand = std::uint32_t(intervals);
    out.points_per_strand = control_points_of(settings.basis, out.segments_per_strand);
    const std::size_t points = strands * out.points_per_strand;
    if (points > std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument("expand: more control points than 32 bits can count");
    }
    const bool hermite = settings.basis == CurveBasis::hermite;
    const bool faces = settings.has_faces();
    if (hermite && faces)
        throw std::invalid_argument("expand: faces are of B-splines alone");
    if (faces && binding.faces.size() != strands)
        throw std::invalid_argument("expand: faces need those that rest_faces chooses");
    const auto fit = [](auto& buffer, std::size_t size) {
        if (buffer.size() != size) buffer = std::decay_t<decltype(buffer)>(size);
    };
    fit(out.points, points);
    fit(out.tangents, hermite ? points : 0);
    fit(out.normals, faces ? points : 0);
    fit(out.segments, strands * intervals);
}

/// Strands [first, last), from their synthesised places.
void expand_states(const Binding& binding, const GuideProfiles<float>& profiles,
                   const KernelGuides& guides, const ExpandSettings& settings,
                   std::size_t first, std::size_t last, Curves& out) {
    const auto put = [&](std::size_t i, std::span<const HelixState<float>> states) {
        const auto own = [&](Buffer<Point4f>& buffer) {
            return buffer.span().subspan(i * out.points_per_strand,
                                         out.points_per_strand);
        };
        const float ds = binding.lengths[i] / float(profiles.count);
        const Vec3f& root = binding.roots.positions[i];
        const Taper taper = settings.taper.times(binding.roots.width(i));
        if (settings.basis == CurveBasis::hermite) {
            hermite_points(states, ds, root, taper, own(out.points), own(out.tangents));
        } else {
            bspline_points(states, ds, root, taper, own(out.points));
        }
        if (settings.has_faces()) {
            const Vec2f face =
                face_at(binding, profiles, settings.blend, i, states[0].frame);
            ribbon_normals(states, face, own(out.normals));
        }
    };
    each_strand(binding, profiles, guides, settings.blend, first, last, put);
}

}  // namespace

void expand(const Binding& binding, const GuideProfiles<float>& profiles,
            const KernelGuides& guides, const ExpandSettings& settings, Curves& out) {
    make_room(binding, std::size_t(profiles.count), settings, out);
    if (out.strands == 0) return;
    const bool whole = guides.size > 0 && has_kernel(settings.blend, settings.basis) &&
                       !settings.has_faces();
    const KernelInput in{binding,        profiles,       guides,
                         settings.blend, settings.basis, settings.taper};
    const bool past_caches = out.bytes() >= kPastCaches;

    const auto expand_chunk = [&](const tbb::blocked_range<std::size_t>& chunk) {
        const std::size_t at = chunk.begin() * out.points_per_strand;
        if (whole) {
            expand_strands(in, {chunk.begin(), chunk.size(), out.points.data() + at,
                                out.tangents.data() + at, past_caches});
        } else {
            expand_states(binding, profiles, guides, settings, chunk.begin(), chunk.end(),
                          out);
        }
        number_segments(
            chunk.begin(), chunk.size(), out.points_per_strand, out.segments_per_strand,
            out.segments.data() + chunk.begin() * out.segments_per_strand, past_caches);
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, out.strands, settings.chunk),
                      expand_chunk, tbb::simple_partitioner());
}

Curves expand(const Binding& binding, const GuideProfiles<float>& profiles,
              const ExpandSettings& settings) {
    Curves out;
    expand(binding, profiles,
           kernel_guides(profiles, binding.guide_normals, settings.blend), settings, out);
    return out;
}

}  // namespace lancret
