#include "procedural/chunk/box.h"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <limits>

#include "guides/base/cancel.h"
#include "guides/helix/helix_box.h"
#include "procedural/curves/emitted_curve.h"

namespace lancret {

namespace {

/// Extends `box` by the helices between places; `root` is where the strand stands.
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

/// The box of children [first, last).
Eigen::AlignedBox3d box_of(const Binding& chunk, std::size_t first, std::size_t last,
                           const GuideProfiles<float>& profiles,
                           const KernelGuides& guides, const ExpandSettings& settings) {
    using Range = tbb::blocked_range<std::size_t>;
    const int n = profiles.count;
    const CurveBasis basis = layout_of(settings.basis).same_curve;
    return cancellable_reduce(
        Range(first, last, 64), Eigen::AlignedBox3d(),
        [&](const Range& range, Eigen::AlignedBox3d out) {
            StrandBuffer curve;
            const auto extend_by = [&](std::size_t i,
                                       std::span<const HelixState<float>> states) {
                const Vec3f& root = chunk.roots.positions[i];
                const float ds = chunk.lengths[i] / float(n);
                emit({.states = states,
                      .ds = ds,
                      .root = root,
                      .ends = traits_of(settings.blend).ends},
                     basis, curve);
                extend_by_helices(out, states, root.cast<double>(), ds);
                extend_by_hull(out, basis, curve.points, curve.tangents);
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
    // The second term is the rounding of floats at this distance from the origin.
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
    // A thousandth is added for round-off, and the rounding of floats at this distance
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
