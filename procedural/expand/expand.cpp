#include "procedural/expand/expand.h"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "guides/base/cancel.h"
#include "procedural/curves/emitted_curve.h"
#include "procedural/expand/faces.h"
#include "procedural/kernels/strand_kernels.h"

namespace lancret {

namespace {

/// Output of this size, bytes, does not stay in the caches until it is read (measured).
constexpr std::size_t kPastCaches = std::size_t(8) << 20;

/// The children [first, last) of one class, with their guides.
struct ClassRange {
    std::size_t first, last;
    const GuideProfiles<float>* profiles;
    const KernelGuides* guides;
};

/// Lays out `out` for the strands of `binding`. Keeps buffers of the right size.
void make_room(const Binding& binding, std::span<const ClassRange> ranges,
               const ExpandSettings& settings, Curves& out) {
    const BasisLayout& layout = layout_of(settings.basis);
    const bool faces = settings.has_faces();
    if (faces && binding.faces.size() != binding.size()) {
        throw std::invalid_argument("expand: the binding has no faces; see rest_faces");
    }
    out.basis = settings.basis;
    out.shape = settings.shape.value_or(CurveShape::flat);
    out.strands = 0;
    out.classes.clear();
    for (const ClassRange& range : ranges) {
        out.add_class(std::uint32_t(range.last - range.first),
                      std::uint32_t(range.profiles->count));
    }
    out.ids = binding.roots.ids;
    const auto fit = [](auto& buffer, std::size_t size) {
        if (buffer.size() != size) buffer = std::decay_t<decltype(buffer)>(size);
    };
    const std::size_t points = out.point_count();
    fit(out.points, points);
    fit(out.tangents, layout.has_tangents || settings.directions ? points : 0);
    fit(out.normals, faces ? points : 0);
    const bool numbered = settings.segments && !is_derived(settings.basis);
    fit(out.segments, numbered ? out.segment_count() : 0);
}

/// Where the control points of the strands from `first` on are written.
struct Rows {
    std::size_t first, in_strand;  ///< in_strand: control points per strand
    Point4f *points, *tangents;    ///< tangents: null if the basis has none

    std::span<Point4f> of(Point4f* rows, std::size_t i) const {
        if (!rows) return {};
        return {rows + (i - first) * in_strand, in_strand};
    }
};

/// Expands the strands of `range` into class `target` of `out`.
class ClassExpansion {
  public:
    ClassExpansion(const Binding& binding, const ClassRange& range,
                   const ExpandSettings& settings, const CurveClass& target, Curves& out)
        : binding_(binding),
          range_(range),
          settings_(settings),
          target_(target),
          out_(out),
          source_(layout_of(settings.basis).source),
          kernel_(range.guides->size > 0 && has_kernel(settings.blend, source_)),
          past_caches_(out.bytes() >= kPastCaches) {}

    void run() {
        using Range = tbb::blocked_range<std::size_t>;
        cancellable_for(
            Range(range_.first, range_.last, settings_.grain),
            [&](const Range& range) {
                if (source_ == settings_.basis) {
                    expand(range.begin(), range.end());
                } else {
                    derive(range.begin(), range.end());
                }
            },
            tbb::simple_partitioner());
    }

  private:
    std::span<Point4f> strand(Buffer<Point4f>& rows, std::size_t i) const {
        return rows.span().subspan(target_.point + (i - target_.strand) * target_.points,
                                   target_.points);
    }

    /// Writes the strands from rows.first to `last` in the source basis, and their
    /// normals in the requested one.
    void fill(const Rows& rows, std::size_t last, bool past_caches) {
        if (kernel_) {
            const KernelInput in{binding_,        *range_.profiles, *range_.guides,
                                 settings_.blend, source_,          settings_.taper};
            expand_strands(in, {rows.first, last - rows.first, rows.points, rows.tangents,
                                past_caches});
        }
        if (!kernel_ || settings_.has_faces()) fill_from_states(rows, last);
    }

    /// Writes what is made from synthesised places: control points if there is no kernel,
    /// and faces.
    void fill_from_states(const Rows& rows, std::size_t last) {
        const GuideProfiles<float>& profiles = *range_.profiles;
        std::vector<Point4f> ribbon(std::size_t(profiles.count) + 3);
        const auto write = [&](std::size_t i, std::span<const HelixState<float>> states) {
            if (!kernel_) {
                emit({.states = states,
                      .ds = binding_.lengths[i] / float(profiles.count),
                      .root = binding_.roots.positions[i],
                      .taper = settings_.taper.times(binding_.roots.width(i)),
                      .ends = traits_of(settings_.blend).ends},
                     source_, rows.of(rows.points, i), rows.of(rows.tangents, i));
            }
            if (settings_.has_faces()) {
                const Vec2f face =
                    face_at(binding_, profiles, settings_.blend, i, states[0].frame);
                ribbon_normals(states, face, ribbon);
                normals_in_basis(settings_.basis, ribbon, strand(out_.normals, i));
            }
        };
        each_strand({binding_, profiles, *range_.guides, settings_.blend}, rows.first,
                    last, write);
    }

    void expand(std::size_t first, std::size_t last) {
        const bool has_tangents = layout_of(source_).has_tangents;
        const std::size_t before = first - target_.strand,
                          point = target_.point + before * target_.points;
        Point4f* const tangents = has_tangents ? out_.tangents.data() + point : nullptr;
        fill({first, target_.points, out_.points.data() + point, tangents}, last,
             past_caches_);
        if (settings_.segments) {
            number_segments(
                point, last - first, target_.points, target_.segments,
                out_.segments.data() + target_.segment + before * target_.segments,
                past_caches_);
        }
        if (has_tangents || out_.tangents.size() == 0) return;
        for (std::size_t i = first; i < last; ++i) {
            bspline_directions(strand(out_.points, i), strand(out_.tangents, i));
        }
    }

    /// Writes the strands of a derived basis, a few at a time so that the Hermite curves
    /// stay in the caches.
    void derive(std::size_t first, std::size_t last) {
        constexpr std::size_t kTogether = 32;
        const std::size_t places = std::size_t(range_.profiles->count) + 1;
        std::vector<Point4f> points(kTogether * places), tangents(points.size());
        for (std::size_t i = first; i < last; i += kTogether) {
            const Rows rows{i, places, points.data(), tangents.data()};
            const std::size_t end = std::min(i + kTogether, last);
            fill(rows, end, false);
            for (std::size_t s = i; s < end; ++s) {
                const auto row_tangents = rows.of(rows.tangents, s);
                points_of_hermite(settings_.basis, rows.of(rows.points, s), row_tangents,
                                  strand(out_.points, s));
                if (out_.tangents.size() == 0) continue;
                directions_of_hermite(settings_.basis, row_tangents,
                                      strand(out_.tangents, s));
            }
        }
    }

    const Binding& binding_;
    const ClassRange& range_;
    const ExpandSettings& settings_;
    const CurveClass& target_;
    Curves& out_;
    CurveBasis source_;  ///< the basis that is emitted first
    bool kernel_, past_caches_;
};

/// Each range has at least one child.
void expand_ranges(const Binding& binding, std::span<const ClassRange> ranges,
                   const ExpandSettings& settings, Curves& out) {
    make_room(binding, ranges, settings, out);
    for (std::size_t r = 0; r < ranges.size(); ++r) {
        ClassExpansion(binding, ranges[r], settings, out.classes[r], out).run();
    }
}

}  // namespace

void expand(const Binding& binding, const ClassedGuides& guides,
            const ExpandSettings& settings, Curves& out) {
    std::vector<ClassRange> ranges;
    each_class(
        guides.classes, binding, [&](std::size_t c, std::size_t first, std::size_t last) {
            ranges.push_back({first, last, &guides.profiles[c], &guides.kernel(c)});
        });
    expand_ranges(binding, ranges, settings, out);
}

Curves expand(const Binding& binding, const ClassedGuides& guides,
              const ExpandSettings& settings) {
    Curves out;
    expand(binding, guides, settings, out);
    return out;
}

void expand(const Binding& binding, const GuideProfiles<float>& profiles,
            const KernelGuides& guides, const ExpandSettings& settings, Curves& out) {
    std::vector<ClassRange> ranges;
    if (binding.size() > 0) ranges.push_back({0, binding.size(), &profiles, &guides});
    expand_ranges(binding, ranges, settings, out);
}

Curves expand(const Binding& binding, const GuideProfiles<float>& profiles,
              const ExpandSettings& settings) {
    Curves out;
    expand(binding, profiles,
           kernel_guides(profiles, binding.guide_normals, settings.blend), settings, out);
    return out;
}

}  // namespace lancret
