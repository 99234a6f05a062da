#include "render_test/material/hair_colour.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lancret {
namespace {

/// -ln(colour) / sqrt(sigma_a) [Chiang et al. 2016, Eq. 9].
float colour_fit(float b) {
    return 5.969f +
           b * (-0.215f + b * (2.532f + b * (-10.73f + b * (5.574f + b * 0.245f))));
}

}  // namespace

void check_hair_colour(const Vec3f& colour) {
    if (!colour.allFinite() || colour.minCoeff() < 0 || colour.maxCoeff() > 1) {
        throw std::invalid_argument("hair colour must be within 0 and 1");
    }
}

Vec3f sigma_a_of_melanin(float eumelanin, float pheomelanin) {
    return eumelanin * Vec3f(0.419f, 0.697f, 1.37f) +
           pheomelanin * Vec3f(0.187f, 0.4f, 1.05f);
}

Vec3f sigma_a_of_colour(const Vec3f& colour, float beta_n) {
    const Eigen::Array3f kept = colour.array().max(0.001f).min(0.999f);
    return (kept.log() / colour_fit(beta_n)).square();
}

Vec3f colour_of_sigma_a(const Vec3f& sigma_a, float beta_n) {
    return (-sigma_a.array().sqrt() * colour_fit(beta_n)).exp();
}

Vec3f sigma_a_of(const HairMaterial& material) {
    if (material.sigma_a) {
        if (!material.sigma_a->allFinite() || material.sigma_a->minCoeff() < 0) {
            throw std::invalid_argument("hair sigma_a must be finite and not negative");
        }
        return *material.sigma_a;
    }
    if (material.colour) {
        check_hair_colour(*material.colour);
        return sigma_a_of_colour(*material.colour, material.beta_n);
    }
    if (!(material.eumelanin >= 0) || !(material.pheomelanin >= 0) ||
        !std::isfinite(material.eumelanin + material.pheomelanin)) {
        throw std::invalid_argument("melanin must be finite and not negative");
    }
    return sigma_a_of_melanin(material.eumelanin, material.pheomelanin);
}

HairMaterial roughened(const HairMaterial& material, float minimum) {
    HairMaterial out = material;
    out.sigma_a = sigma_a_of(material);
    out.beta_m = std::max(material.beta_m, minimum);
    out.beta_n = std::max(material.beta_n, minimum);
    return out;
}

}  // namespace lancret
