#pragma once
// The measurements of a strand, listed once for every report.

#include "procedural/check/check.h"

namespace lancret {

/// A measurement of a strand and its names in reports.
struct Figure {
    const char* key;      ///< in JSON
    const char* max_key;  ///< of its maximum, in JSON
    const char* title;    ///< in tables
    float StrandCheck::*value;
    double CheckTolerances::*tolerance;
};
inline constexpr Figure kFigures[] = {
    {"orthogonality", "max", "orthogonality |R^T R - I|", &StrandCheck::orthogonality,
     &CheckTolerances::orthogonality},
    {"length", "max_relative_error", "length, relative", &StrandCheck::length_error,
     &CheckTolerances::length},
    {"emitted_length", "max_relative_error", "length as emitted, relative",
     &StrandCheck::emitted_length_error, &CheckTolerances::emitted_length},
    {"distance", "max_cm", "curve from strand, cm", &StrandCheck::distance,
     &CheckTolerances::distance},
    {"root", "max_cm", "curve from its root, cm", &StrandCheck::root_distance,
     &CheckTolerances::root},
};

/// The largest absolute value of every figure over the strands; NaN counts as infinite.
/// The other fields have their defaults.
StrandCheck largest_figures(const CheckReport& report);

}  // namespace lancret
