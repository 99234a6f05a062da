#pragma once
// What all materials share: values and samples of a BSDF, and the Fresnel term.

#include <cmath>

#include "guides/base/types.h"

namespace lancret {

/// A value and the density of sampling it, always from one evaluation.
struct BsdfValue {
    Vec3f value = Vec3f::Zero();  ///< BSDF times cosine, 1/sr
    float pdf = 0;                ///< 1/sr
};

struct BsdfSample {
    Vec3f direction;  ///< unit
    BsdfValue at;     ///< pdf > 0
};

inline float square(float x) { return x * x; }

/// Reflectance of a dielectric interface of relative index `eta` > 1, met from outside.
inline float fresnel_dielectric(float cosine, float eta) {
    const float sine_t2 = (1 - cosine * cosine) / (eta * eta);
    const float cosine_t = std::sqrt(1 - sine_t2);
    const float parallel = (eta * cosine - cosine_t) / (eta * cosine + cosine_t);
    const float across = (cosine - eta * cosine_t) / (cosine + eta * cosine_t);
    return 0.5f * (parallel * parallel + across * across);
}

}  // namespace lancret
