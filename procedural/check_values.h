#pragma once
// What check measures, kept place by place: for pictures of it.

#include "procedural/check.h"

namespace lancret {

/// A figure along every strand. What is not a finite number counts as the largest float.
struct StrandValues {
    bool at_places = false;            ///< at the ends of equal intervals, else in them
    std::vector<float> values;         ///< strand after strand, root first
    std::vector<std::size_t> first{};  ///< [strands + 1], into `values`; or empty: one
                                       ///< value a strand, of it as a whole

    std::size_t strands() const {
        return first.empty() ? values.size() : first.size() - 1;
    }
    std::span<const float> of(std::size_t strand) const {
        if (first.empty()) return std::span(values).subspan(strand, 1);
        return std::span(values).subspan(first[strand],
                                         first[strand + 1] - first[strand]);
    }
    /// At `along`, 0 at the root to 1 at the tip: linear between places, even within an
    /// interval.
    float at(std::uint32_t strand, float along) const;
};

/// The sizes of the strands' relative length errors, as `check` has found them.
StrandValues length_error_values(const CheckReport& report);

/// max |R^T R - I| at every place. Their largest on a strand is what `check` reports.
StrandValues orthogonality_values(const Binding& binding, const ClassedGuides& guides,
                                  Blend blend);

/// Curvature and torsion in every interval, 1/cm, as `check` compares them with the
/// guides'.
StrandValues curvature_values(const Binding& binding, const ClassedGuides& guides,
                              Blend blend);
StrandValues torsion_values(const Binding& binding, const ClassedGuides& guides,
                            Blend blend);

/// Whether frames of this blend turn about the tangent as the curl does; else they are
/// carried without twist and know no torsion.
bool has_torsion(Blend blend);

/// The guide that each strand follows most: its index.
StrandValues leading_guide_values(const Binding& binding);

}  // namespace lancret
