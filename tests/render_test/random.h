#pragma once
// Seeded random numbers for tests of the path tracer.

#include <random>

#include "guides/base/types.h"
#include "render_test/sampling/sampler.h"

namespace lancret {

/// Numbers in [0, 1).
struct Random {
    std::mt19937 engine;
    float operator()() { return unit_float(engine()); }
    Vec2f pair() {
        const float x = (*this)();
        return {x, (*this)()};
    }
};

}  // namespace lancret
