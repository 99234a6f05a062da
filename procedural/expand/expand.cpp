#include "procedural/expand/expand.h"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "guides/base/cancel.h"
#include "procedural/expand/faces.h"
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
    fit(out.tangents, hermite || settings.directions ? points : 0);
    fit(out.normals, faces ? points : 0);
    const bool numbered = settings.segments && !is_of_hermite(settings.basis);
    fit(out.segments, numbered ? out.segment_count() : 0);
}

/// Where the control points of strands from `first` on go.
struct Rows {
    std::size_t first, in_strand;
    Point4f *points, *tangents;

    std::span<Point4f> of(Point4f* rows, std::size_t i) const {
        return {rows + (i - first) * in_strand, in_strand};
    }
};

/// Expands the strands of `part`, to where `own` says that they go among all.
class PartExpansion {
  public:
    PartExpansion(const Binding& binding, const Part& part,
                  const ExpandSettings& settings, const CurveClass& own, Curves& out)
        : binding_(binding),
          part_(part),
          settings_(settings),
          own_(own),
          out_(out),
          basis_(is_of_hermite(settings.basis) ? CurveBasis::hermite : settings.basis),
          kernel_(part.guides->size > 0 && has_kernel(settings.blend, basis_)),
          past_caches_(out.bytes() >= kPastCaches) {}

    void run() {
        using Range = tbb::blocked_range<std::size_t>;
        cancellable_for(
            Range(part_.first, part_.last, settings_.chunk),
            [&](const Range& range) {
                if (basis_ == settings_.basis) {
                    expand(range.begin(), range.end());
                } else {
                    derive(range.begin(), range.end());
                }
            },
            tbb::simple_partitioner());
    }

  private:
    std::span<Point4f> strand(Buffer<Point4f>& rows, std::size_t i) const {
        return rows.span().subspan(own_.point + (i - own_.strand) * own_.points,
                                   own_.points);
    }

    /// Strands from rows.first to `last` as B-splines or Hermite curves; and their
    /// normals in any basis.
    void fill(const Rows& rows, std::size_t last, bool past_caches) {
        if (kernel_) {
            const KernelInput in{binding_,        *part_.profiles, *part_.guides,
                                 settings_.blend, basis_,          settings_.taper};
            expand_strands(in, {rows.first, last - rows.first, rows.points, rows.tangents,
                                past_caches});
        }
        if (!kernel_ || settings_.has_faces()) fill_from_states(rows, last);
    }

    /// From synthesised places: control points where no kernel makes those, and faces.
    void fill_from_states(const Rows& rows, std::size_t last) {
        const GuideProfiles<float>& profiles = *part_.profiles;
        std::vector<Point4f> ribbon(std::size_t(profiles.count) + 3);
        const auto put = [&](std::size_t i, std::span<const HelixState<float>> states) {
            const float ds = binding_.lengths[i] / float(profiles.count);
            const Vec3f& root = binding_.roots.positions[i];
            const Taper taper = settings_.taper.times(binding_.roots.width(i));
            if (!kernel_ && basis_ == CurveBasis::bspline) {
                bspline_points(states, ds, root, taper, rows.of(rows.points, i),
                               traits_of(settings_.blend).ends);
            } else if (!kernel_) {
                hermite_points(states, ds, root, taper, rows.of(rows.points, i),
                               rows.of(rows.tangents, i));
            }
            if (settings_.has_faces()) {
                const Vec2f face =
                    face_at(binding_, profiles, settings_.blend, i, states[0].frame);
                ribbon_normals(states, face, ribbon);
                normals_in_basis(settings_.basis, ribbon, strand(out_.normals, i));
            }
        };
        each_strand({binding_, profiles, *part_.guides, settings_.blend}, rows.first,
                    last, put);
    }

    void expand(std::size_t first, std::size_t last) {
        const std::size_t before = first - own_.strand,
                          at = own_.point + before * own_.points;
        Point4f* const tangents =
            basis_ == CurveBasis::hermite ? out_.tangents.data() + at : nullptr;
        fill({first, own_.points, out_.points.data() + at, tangents}, last, past_caches_);
        if (settings_.segments) {
            number_segments(at, last - first, own_.points, own_.segments,
                            out_.segments.data() + own_.segment + before * own_.segments,
                            past_caches_);
        }
        if (basis_ == CurveBasis::hermite || out_.tangents.size() == 0) return;
        for (std::size_t i = first; i < last; ++i) {
            bspline_directions(strand(out_.points, i), strand(out_.tangents, i));
        }
    }

    /// What is made of Hermite's points: a few at a time, so that those stay in the
    /// cache.
    void derive(std::size_t first, std::size_t last) {
        constexpr std::size_t kTogether = 32;
        const std::size_t places = std::size_t(part_.profiles->count) + 1;
        std::vector<Point4f> points(kTogether * places), tangents(points.size());
        for (std::size_t i = first; i < last; i += kTogether) {
            const Rows rows{i, places, points.data(), tangents.data()};
            const std::size_t end = std::min(i + kTogether, last);
            fill(rows, end, false);
            for (std::size_t s = i; s < end; ++s) {
                const auto along = rows.of(rows.tangents, s);
                points_of_hermite(settings_.basis, rows.of(rows.points, s), along,
                                  strand(out_.points, s));
                if (out_.tangents.size() == 0) continue;
                directions_of_hermite(settings_.basis, along, strand(out_.tangents, s));
            }
        }
    }

    const Binding& binding_;
    const Part& part_;
    const ExpandSettings& settings_;
    const CurveClass& own_;
    Curves& out_;
    CurveBasis basis_;  ///< that is made first
    bool kernel_, past_caches_;
};

/// `parts` are not empty.
void expand_parts(const Binding& binding, std::span<const Part> parts,
                  const ExpandSettings& settings, Curves& out) {
    make_room(binding, parts, settings, out);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        PartExpansion(binding, parts[p], settings, out.classes[p], out).run();
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
