#include "procedural/expand.h"

#include <oneapi/tbb/blocked_range.h>

#include <limits>
#include <stdexcept>
#include <type_traits>

#include "guides/cancel.h"
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
    if (faces && binding.faces.size() != strands)
        throw std::invalid_argument("expand: faces need those that rest_faces chooses");
    const auto fit = [](auto& buffer, std::size_t size) {
        if (buffer.size() != size) buffer = std::decay_t<decltype(buffer)>(size);
    };
    fit(out.points, points);
    fit(out.tangents, hermite || settings.directions ? points : 0);
    fit(out.normals, faces ? points : 0);
    fit(out.segments, is_of_hermite(settings.basis) ? 0 : strands * intervals);
}

std::span<Point4f> strand_of(Buffer<Point4f>& rows, std::size_t i, const Curves& curves) {
    return rows.span().subspan(i * curves.points_per_strand, curves.points_per_strand);
}

/// Where the control points of strands from `first` on go.
struct Rows {
    std::size_t first, in_strand;
    Point4f *points, *tangents;

    std::span<Point4f> of(Point4f* rows, std::size_t i) const {
        return {rows + (i - first) * in_strand, in_strand};
    }
};

/// Strands [first, last), from their synthesised places, as B-splines or Hermite curves;
/// and their normals in any basis.
void expand_states(const Binding& binding, const GuideProfiles<float>& profiles,
                   const KernelGuides& guides, const ExpandSettings& settings,
                   const Rows& rows, std::size_t last, Curves& out) {
    std::vector<Point4f> ribbon(std::size_t(profiles.count) + 3);
    const auto put = [&](std::size_t i, std::span<const HelixState<float>> states) {
        const float ds = binding.lengths[i] / float(profiles.count);
        const Vec3f& root = binding.roots.positions[i];
        const Taper taper = settings.taper.times(binding.roots.width(i));
        if (settings.basis == CurveBasis::bspline) {
            bspline_points(states, ds, root, taper, rows.of(rows.points, i));
        } else {
            hermite_points(states, ds, root, taper, rows.of(rows.points, i),
                           rows.of(rows.tangents, i));
        }
        if (settings.has_faces()) {
            const Vec2f face =
                face_at(binding, profiles, settings.blend, i, states[0].frame);
            ribbon_normals(states, face, ribbon);
            normals_in_basis(settings.basis, ribbon, strand_of(out.normals, i, out));
        }
    };
    each_strand(binding, profiles, guides, settings.blend, rows.first, last, put);
}

/// What of a strand comes after its points.
void put_directions(CurveBasis basis, std::size_t i, Curves& out) {
    if (basis == CurveBasis::bspline && out.tangents.size() > 0) {
        bspline_directions(strand_of(out.points, i, out),
                           strand_of(out.tangents, i, out));
    }
}

}  // namespace

void expand(const Binding& binding, const GuideProfiles<float>& profiles,
            const KernelGuides& guides, const ExpandSettings& settings, Curves& out) {
    make_room(binding, std::size_t(profiles.count), settings, out);
    if (out.strands == 0) return;
    const bool derived = is_of_hermite(settings.basis);
    const CurveBasis basis = derived ? CurveBasis::hermite : settings.basis;
    const bool whole =
        guides.size > 0 && has_kernel(settings.blend, basis) && !settings.has_faces();
    const KernelInput in{binding,        profiles, guides,
                         settings.blend, basis,    settings.taper};
    const bool past_caches = out.bytes() >= kPastCaches;

    const auto fill = [&](const Rows& rows, std::size_t last, bool past) {
        if (whole) {
            expand_strands(
                in, {rows.first, last - rows.first, rows.points, rows.tangents, past});
        } else {
            expand_states(binding, profiles, guides, settings, rows, last, out);
        }
    };
    const auto expand_chunk = [&](const tbb::blocked_range<std::size_t>& chunk) {
        const std::size_t at = chunk.begin() * out.points_per_strand;
        fill({chunk.begin(), out.points_per_strand, out.points.data() + at,
              out.tangents.data() + at},
             chunk.end(), past_caches);
        number_segments(
            chunk.begin(), chunk.size(), out.points_per_strand, out.segments_per_strand,
            out.segments.data() + chunk.begin() * out.segments_per_strand, past_caches);
        for (std::size_t i = chunk.begin(); i < chunk.end(); ++i) {
            put_directions(settings.basis, i, out);
        }
    };
    // A few at a time, so that what they are made of stays in the cache.
    const auto derive_chunk = [&](const tbb::blocked_range<std::size_t>& chunk) {
        constexpr std::size_t kTogether = 32;
        const std::size_t places = std::size_t(profiles.count) + 1;
        std::vector<Point4f> points(kTogether * places), tangents(points.size());
        for (std::size_t i = chunk.begin(); i < chunk.end(); i += kTogether) {
            const Rows rows{i, places, points.data(), tangents.data()};
            const std::size_t last = std::min(i + kTogether, chunk.end());
            fill(rows, last, false);
            for (std::size_t s = i; s < last; ++s) {
                const auto along = rows.of(rows.tangents, s);
                points_of_hermite(settings.basis, rows.of(rows.points, s), along,
                                  strand_of(out.points, s, out));
                if (out.tangents.size() == 0) continue;
                directions_of_hermite(settings.basis, along,
                                      strand_of(out.tangents, s, out));
            }
        }
    };
    const tbb::blocked_range<std::size_t> all(0, out.strands, settings.chunk);
    if (derived) {
        cancellable_for(all, derive_chunk, tbb::simple_partitioner());
    } else {
        cancellable_for(all, expand_chunk, tbb::simple_partitioner());
    }
}

Curves expand(const Binding& binding, const GuideProfiles<float>& profiles,
              const ExpandSettings& settings) {
    Curves out;
    expand(binding, profiles,
           kernel_guides(profiles, binding.guide_normals, settings.blend), settings, out);
    return out;
}

}  // namespace lancret
