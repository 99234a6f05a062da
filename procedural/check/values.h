#pragma once
// What check measures, kept place by place: for pictures of it.

#include "procedural/check/check.h"
#include "procedural/curves/strand_values.h"

namespace lancret {

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

}  // namespace lancret
