#pragma once
// The guides and weights of each child. Made once, in the rest pose, and constant over
// time, so that nothing pops.

#include <span>
#include <string>
#include <vector>

#include "guides/helix/guides.h"
#include "procedural/bind/report.h"
#include "procedural/bind/settings.h"
#include "procedural/roots/roots.h"

namespace lancret {

class GuideLookup;

/// Children bound to their guides. Child i owns [i * neighbours, (i + 1) * neighbours) of
/// `guides` and `weights`; unused entries have weight 0.
struct Binding {
    int neighbours = 0;
    Roots roots;                        ///< of the children
    std::vector<std::uint32_t> guides;  ///< [children * neighbours]
    std::vector<float> weights;         ///< [children * neighbours], sum 1 per child
    std::vector<float> lengths;         ///< [children], cm: the intended length
    std::vector<Vec3f> guide_normals;   ///< [guides], the scalp's normal at each guide's
                                        ///< root, at rest
    std::vector<Vec2f> faces;  ///< [children], from rest_faces; empty if not requested
    BindReport report;

    std::size_t size() const { return lengths.size(); }
    std::size_t bytes() const;  ///< of the arrays
};

/// Binds children at `roots` to `guides` in their rest pose; `guide_normals` are the
/// scalp's normals there. A child's guides are the nearest of its region that no parting
/// hides and whose normals lie within the maximum angle. Weights are continuous in root
/// and normal as long as the root stays in its region and on its side of the partings
/// (docs/weights.md). The result does not depend on the number of threads. Throws
/// std::invalid_argument if there are no guides, or if settings or borders do not fit.
Binding bind(Roots roots, const Guides& guides, std::vector<Vec3f> guide_normals,
             const BindSettings& settings, const BindBorders& borders = {});

/// The same, with a `lookup` that was made from these guides and borders.guide_regions.
Binding bind(Roots roots, const Guides& guides, const GuideLookup& lookup,
             std::vector<Vec3f> guide_normals, const BindSettings& settings,
             const BindBorders& borders = {});

/// The children `which` of a binding, in this order, with unchanged bits and an empty
/// report.
Binding picked(const Binding& binding, std::span<const std::uint32_t> which);

}  // namespace lancret
