#pragma once
// Which guides each child has, and by how much: made once, in the rest pose, and never
// changed with time, so that nothing pops.

#include <span>
#include <string>
#include <vector>

#include "guides/helix/guides.h"
#include "procedural/bind/settings.h"
#include "procedural/roots/roots.h"

namespace lancret {

class GuideLookup;

/// What binding had to work around, by name: numbers of children.
struct BindReport {
    /// No guide within reach faces: their weights go by distance alone.
    std::size_t no_facing_guide = 0;
    /// None within the greatest distance and angle: they follow the nearest guide that
    /// they see.
    std::size_t no_guide_in_reach = 0;
    /// Partings hide all of the nearest kMaxCandidates: they follow the nearest guide.
    std::size_t no_guide_in_sight = 0;
    /// Their region has no guide: they are bound to those of all regions.
    std::size_t no_guide_in_region = 0;
    /// The root tangents of their guides, turned to their normal, nearly cancel (a mean
    /// below kOpposedTangents), or a guide's normal is opposed to theirs, so that the
    /// turn is any of many: where nothing is left of the mean, the heaviest guide leads.
    std::size_t opposed_root_frames = 0;
    /// All their guides are straight and have no Frenet normal: the guides' own first
    /// axis serves, and the child is straight.
    std::size_t straight_guides = 0;

    BindReport& operator+=(const BindReport& more);
};
inline constexpr double kOpposedTangents = 0.1;

/// Children bound to their guides. Child i owns [i * neighbours, (i + 1) * neighbours) of
/// `guides` and `weights`; unused places have weight 0.
struct Binding {
    int neighbours = 0;
    Roots roots;                        ///< of the children
    std::vector<std::uint32_t> guides;  ///< [children * neighbours]
    std::vector<float> weights;         ///< [children * neighbours], sum 1 for each child
    std::vector<float> lengths;         ///< [children], cm: the intended length
    std::vector<Vec3f>
        guide_normals;  ///< [guides], of the scalp at each guide's root, at rest
    std::vector<Vec2f>
        faces;  ///< [children], of rest_faces; or empty: none are asked for
    BindReport report;

    std::size_t size() const { return lengths.size(); }
    std::size_t bytes() const;  ///< of the arrays
};

/// Binds children at `roots` to `guides` in their rest pose. `guide_normals` are the
/// scalp's there. A child's guides are the nearest of its region that no parting hides
/// and that lie within the greatest angle; weights are continuous in root and normal, as
/// docs/weights.md shows, while a root keeps to its region and its side of the partings.
/// The same for any number of threads. Throws std::invalid_argument where there are no
/// guides, or settings or borders do not fit.
Binding bind(Roots roots, const Guides& guides, std::vector<Vec3f> guide_normals,
             const BindSettings& settings, const BindBorders& borders = {});

/// The same, where `bound` was made of these guides and borders.guide_regions before.
Binding bind(Roots roots, const Guides& guides, const GuideLookup& bound,
             std::vector<Vec3f> guide_normals, const BindSettings& settings,
             const BindBorders& borders = {});

/// Some of a binding's children, in the order of `which`, with the bits that they have
/// there and an empty report.
Binding picked(const Binding& binding, std::span<const std::uint32_t> which);

}  // namespace lancret
