#include "procedural/expand.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <stdexcept>
#include <type_traits>

#include "procedural/faces.h"
#include "procedural/kernels/strand_kernels.h"

namespace lancret {

namespace {

/// Output of this size does not stay in a cache until somebody reads it: measured.
constexpr std::size_t kPastCaches = std::size_t(8) << 20;

/// Children [first, last), alike, and what they read.
struct Part {
    std::size_t first, last;
    const GuideProfiles<float>* profiles;
    const KernelGuides* guides;
};

/// An empty frame for the strands of `binding`, in the buffers of `out` where they fit.
void make_room(const Binding& binding, std::span<const Part> parts,
               const ExpandSettings& settings, Curves& out) {
    const bool hermite = settings.basis == CurveBasis::hermite;
    const bool faces = settings.has_faces();
    if (hermite && faces)
        throw std::invalid_argument("expand: faces are of B-splines alone");
    if (faces && binding.faces.size() != binding.size())
        throw std::invalid_argument("expand: faces need those that rest_faces chooses");
    out.basis = settings.basis;
    out.shape = settings.shape.value_or(CurveShape::flat);
    out.strands = 0;
    out.classes.clear();
    for (const Part& part : parts) {
        out.add_class(std::uint32_t(part.last - part.first),
                      std::uint32_t(part.profiles->count));
    }
    out.ids = binding.roots.ids;
    const auto fit = [](auto& buffer, std::size_t size) {
        if (buffer.size() != size) buffer = std::decay_t<decltype(buffer)>(size);
    };
    const std::size_t points = out.point_count();
    fit(out.points, points);
    fit(out.tangents, hermite ? points : 0);
    fit(out.normals, faces ? points : 0);
    fit(out.segments, out.segment_count());
}

/// Strands [first, last) of `part`, which `own` says where they go, from their
/// synthesised places: their control points where no kernel makes those, and faces.
void expand_states(const Binding& binding, const Part& part,
                   const ExpandSettings& settings, const CurveClass& own,
                   std::size_t first, std::size_t last, bool points, Curves& out) {
    const GuideProfiles<float>& profiles = *part.profiles;
    const auto put = [&](std::size_t i, std::span<const HelixState<float>> states) {
        const auto to = [&](Buffer<Point4f>& buffer) {
            return buffer.span().subspan(own.point + (i - own.strand) * own.points,
                                         own.points);
        };
        const float ds = binding.lengths[i] / float(profiles.count);
        const Vec3f& root = binding.roots.positions[i];
        const Taper taper = settings.taper.times(binding.roots.width(i));
        if (points && settings.basis == CurveBasis::hermite) {
            hermite_points(states, ds, root, taper, to(out.points), to(out.tangents));
        } else if (points) {
            bspline_points(states, ds, root, taper, to(out.points),
                           ends_of(settings.blend));
        }
        if (settings.has_faces()) {
            const Vec2f face =
                face_at(binding, profiles, settings.blend, i, states[0].frame);
            ribbon_normals(states, face, to(out.normals));
        }
    };
    each_strand(binding, profiles, *part.guides, settings.blend, first, last, put);
}

/// The strands of `part`, in their place among all.
void expand_part(const Binding& binding, const Part& part, const ExpandSettings& settings,
                 const CurveClass& own, bool past_caches, Curves& out) {
    const bool kernel =
        part.guides->size > 0 && has_kernel(settings.blend, settings.basis);
    const KernelInput in{binding,        *part.profiles, *part.guides,
                         settings.blend, settings.basis, settings.taper};
    const auto expand_chunk = [&](const tbb::blocked_range<std::size_t>& chunk) {
        const std::size_t before = chunk.begin() - own.strand;
        const std::size_t at = own.point + before * own.points;
        if (kernel) {
            Point4f* const tangents =
                out.tangents.size() > 0 ? out.tangents.data() + at : nullptr;
            expand_strands(in, {chunk.begin(), chunk.size(), out.points.data() + at,
                                tangents, past_caches});
        }
        if (!kernel || settings.has_faces()) {
            expand_states(binding, part, settings, own, chunk.begin(), chunk.end(),
                          !kernel, out);
        }
        number_segments(at, chunk.size(), own.points, own.segments,
                        out.segments.data() + own.segment + before * own.segments,
                        past_caches);
    };
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(part.first, part.last, settings.chunk),
        expand_chunk, tbb::simple_partitioner());
}

/// `parts` are not empty.
void expand_parts(const Binding& binding, std::span<const Part> parts,
                  const ExpandSettings& settings, Curves& out) {
    make_room(binding, parts, settings, out);
    const bool past_caches = out.bytes() >= kPastCaches;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        expand_part(binding, parts[p], settings, out.classes[p], past_caches, out);
    }
}

}  // namespace

void expand(const Binding& binding, const ClassedGuides& guides,
            const ExpandSettings& settings, Curves& out) {
    std::vector<Part> parts;
    each_class(guides.classes, binding,
               [&](std::size_t c, std::size_t first, std::size_t last) {
                   parts.push_back({first, last, &guides.profiles[c], &guides.kernel(c)});
               });
    expand_parts(binding, parts, settings, out);
}

Curves expand(const Binding& binding, const ClassedGuides& guides,
              const ExpandSettings& settings) {
    Curves out;
    expand(binding, guides, settings, out);
    return out;
}

void expand(const Binding& binding, const GuideProfiles<float>& profiles,
            const KernelGuides& guides, const ExpandSettings& settings, Curves& out) {
    std::vector<Part> parts;
    if (binding.size() > 0) parts.push_back({0, binding.size(), &profiles, &guides});
    expand_parts(binding, parts, settings, out);
}

Curves expand(const Binding& binding, const GuideProfiles<float>& profiles,
              const ExpandSettings& settings) {
    Curves out;
    expand(binding, profiles,
           kernel_guides(profiles, binding.guide_normals, settings.blend), settings, out);
    return out;
}

}  // namespace lancret
