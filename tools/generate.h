#pragma once
// From a groom to its strands, for commands that look at more than the curves.

#include "procedural/generator.h"

namespace lancret {

/// Throws InputError, before any work, where a groom asks for more control points than 32
/// bits can count.
void check_asked_points(const Groom& groom);

/// make_generator with its stages on a terminal and its warnings on stderr. Throws
/// InputError.
Generator run_generator(const Groom& groom);

/// What is worth telling of a groom's guides, on stderr.
void tell_warnings(const Generator& generator);

}  // namespace lancret
