#include "sim/simulation_settings.h"

#include <algorithm>

namespace lancret {

void add(SimulationReport& to, const SimulationReport& from) {
    to.steps += from.steps;
    to.iterations += from.iterations;
    to.unconverged += from.unconverged;
    to.unsolved += from.unsolved;
    to.deepest = std::max(to.deepest, from.deepest);
    to.largest_error = std::max(to.largest_error, from.largest_error);
}

}  // namespace lancret
