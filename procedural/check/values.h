#pragma once
// The measurements of the check along every strand, for rendering them.

#include "procedural/check/check.h"
#include "procedural/curves/strand_values.h"

namespace lancret {

/// The absolute relative length error of every strand.
StrandValues length_error_values(const CheckReport& report);

/// max |R^T R - I| at every place. The largest of a strand is StrandCheck::orthogonality.
StrandValues orthogonality_values(const Binding& binding, const ClassedGuides& guides,
                                  Blend blend);

/// Curvature in every interval, 1/cm, as the check compares it with that of the guides.
StrandValues curvature_values(const Binding& binding, const ClassedGuides& guides,
                              Blend blend);
/// Torsion in every interval, 1/cm.
StrandValues torsion_values(const Binding& binding, const ClassedGuides& guides,
                            Blend blend);

}  // namespace lancret
