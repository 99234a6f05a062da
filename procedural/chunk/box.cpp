#include "procedural/chunk/box.h"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <limits>

#include "guides/base/cancel.h"
#include "guides/helix/helix_box.h"

namespace lancret {

namespace {

/// Room for one strand's control points.
struct Strand {
    CurveBasis basis;
    std::vector<Point4f> points, tangents, in_basis;

    // What is made of Hermite's points is that at first.
    Strand(int intervals, CurveBasis of)
        : basis(of),
          points(control_points_of(is_of_hermite(of) ? CurveBasis::hermite : of,
                                   std::uint32_t(intervals))),
          tangents(of == CurveBasis::bspline ? 0 : points.size()),
          in_basis(of == CurveBasis::catmull_rom ? points.size() + 2 : 0) {}
};

Vec3 place(const Point4f& p) { return p.xyz().cast<double>(); }

/// The helices between places, from the root at `root`.
void extend_by_helices(Eigen::AlignedBox3d& box,
                       std::span<const HelixState<float>> states, const Vec3& root,
                       double ds) {
    for (std::size_t i = 0; i + 1 < states.size(); ++i) {
        const HelixState<double> from{states[i].frame.cast<double>(),
                                      root + states[i].position.cast<double>()};
        const Vec3 turn = rotation_log<double>(from.frame.transpose() *
                                               states[i + 1].frame.cast<double>());
        extend(box, from, turn / ds, ds);
    }
    box.extend(root + states.back().position.cast<double>());
}

/// The Bezier points of the emitted curve.
void extend_by_curve(Eigen::AlignedBox3d& box, const Strand& strand) {
    const std::span points = strand.points;
    if (strand.basis == CurveBasis::linear) {
        for (const Point4f& p : points) box.extend(place(p));
        return;
    }
    if (strand.basis == CurveBasis::catmull_rom) {
        const std::span c = strand.in_basis;
        for (std::size_t j = 1; j + 1 < c.size(); ++j) {
            const Vec3 p = place(c[j]), sixth = (place(c[j + 1]) - place(c[j - 1])) / 6;
            box.extend(p).extend(p - sixth).extend(p + sixth);
        }
        return;
    }
    if (!strand.tangents.empty()) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3 p = place(points[i]), third = place(strand.tangents[i]) / 3;
            box.extend(p);
            if (i > 0) box.extend(p - third);
            if (i + 1 < points.size()) box.extend(p + third);
        }
        return;
    }
    for (std::size_t j = 1; j + 1 < points.size(); ++j) {
        const Vec3 before = place(points[j - 1]), p = place(points[j]),
                   after = place(points[j + 1]);
        box.extend((before + 4 * p + after) / 6);
        if (j + 2 < points.size()) {
            box.extend((2 * p + after) / 3).extend((p + 2 * after) / 3);
        }
    }
}

/// The box of children [first, last).
Eigen::AlignedBox3d box_of(const Binding& chunk, std::size_t first, std::size_t last,
                           const GuideProfiles<float>& profiles,
                           const KernelGuides& guides, const ExpandSettings& settings) {
    using Range = tbb::blocked_range<std::size_t>;
    const int n = profiles.count;
    return cancellable_reduce(
        Range(first, last, 64), Eigen::AlignedBox3d(),
        [&](const Range& range, Eigen::AlignedBox3d out) {
            Strand strand(n, settings.basis);
            const auto extend_by = [&](std::size_t i,
                                       std::span<const HelixState<float>> states) {
                const Vec3f& root = chunk.roots.positions[i];
                const float ds = chunk.lengths[i] / float(n);
                if (strand.tangents.empty()) {
                    bspline_points(states, ds, root, {}, strand.points,
                                   traits_of(settings.blend).ends);
                } else {
                    hermite_points(states, ds, root, {}, strand.points, strand.tangents);
                    if (settings.basis == CurveBasis::catmull_rom) {
                        points_of_hermite(settings.basis, strand.points, strand.tangents,
                                          strand.in_basis);
                    }
                }
                extend_by_helices(out, states, root.cast<double>(), ds);
                extend_by_curve(out, strand);
            };
            each_strand({chunk, profiles, guides, settings.blend}, range.begin(),
                        range.end(), extend_by);
            return out;
        },
        [](Eigen::AlignedBox3d a, const Eigen::AlignedBox3d& b) { return a.extend(b); });
}

}  // namespace

Eigen::AlignedBox3f ChunkBox::box() const {
    if (places.isEmpty()) return places;
    return {places.min().array() - radius, places.max().array() + radius};
}

ChunkBox& ChunkBox::extend(const ChunkBox& other) {
    places.extend(other.places);
    radius = std::max(radius, other.radius);
    return *this;
}

ChunkBox chunk_box(const Binding& chunk, const ClassedGuides& guides,
                   const ExpandSettings& settings) {
    Eigen::AlignedBox3d box;
    each_class(guides.classes, chunk,
               [&](std::size_t c, std::size_t first, std::size_t last) {
                   box.extend(box_of(chunk, first, last, guides.profiles[c],
                                     guides.kernel(c), settings));
               });
    ChunkBox out;
    if (box.isEmpty()) return out;
    float width = 0;
    for (std::size_t i = 0; i < chunk.size(); ++i) {
        width = std::max(width, chunk.roots.width(i));
    }
    out.radius = settings.taper.times(width).largest();
    const double longest = std::ranges::max(chunk.lengths);
    const double far =
        std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    // And what a float cannot tell of places this far from the origin.
    const double room = 5e-7 * guides.finest().count * longest +
                        4 * far * std::numeric_limits<float>::epsilon();
    out.places = {(box.min().array() - room).cast<float>(),
                  (box.max().array() + room).cast<float>()};
    return out;
}

ChunkBox reach_box(const Eigen::AlignedBox3f& roots, float longest, int n,
                   const ExpandSettings& settings, double density) {
    ChunkBox out;
    if (roots.isEmpty()) return out;
    // A thousandth more, for round-off, and what a float cannot tell of places this far
    // from the origin.
    const float far =
        std::max(roots.min().cwiseAbs().maxCoeff(), roots.max().cwiseAbs().maxCoeff());
    const float reach = longest * (1.001f + 13.0f / (3 * float(n))) +
                        8 * far * std::numeric_limits<float>::epsilon();
    out.places = {roots.min().array() - reach, roots.max().array() + reach};
    out.radius = settings.taper.times(float(1 / density)).largest();
    return out;
}

}  // namespace lancret
