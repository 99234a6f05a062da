#pragma once
// Guides on a plane and children between them, for tests.

#include <random>

#include "procedural/bind/binding.h"
#include "procedural/expand/expand.h"
#include "tests/procedural/made_guides.h"

namespace lancret::test {

/// Guides on the square [0, side]^2 at z = 0, whose tangents lean from +Z by up to about
/// 0.5 radian, and the normals at their roots.
struct StandingGuides {
    Guides guides;
    std::vector<Vec3f> normals;
};

inline StandingGuides standing_guides(int count, int segments, unsigned seed,
                                      double curvature = 0.3, double side = 10) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, curvature), lean(0, 0.25);
    std::uniform_real_distribution<double> length(8, 16), place(0, side), turn(0, 6.28);
    StandingGuides out;
    for (int g = 0; g < count; ++g) {
        std::vector<Vec3> u;
        for (int q = 0; q < segments; ++q) {
            const double k0 = normal(random), k1 = normal(random), k2 = normal(random);
            u.emplace_back(k0, k1, k2);
        }
        const double x = lean(random), y = lean(random), angle = turn(random);
        const Vec3 tangent = Vec3(x, y, 1).normalized();
        const Vec3 across =
            tangent.cross(Vec3(std::cos(angle), std::sin(angle), 0)).normalized();
        Mat3 frame;
        frame << tangent, across, tangent.cross(across);
        const double px = place(random), py = place(random);
        add_guide(out.guides, u, length(random), frame, {px, py, 0});
        out.normals.push_back(Vec3f::UnitZ());
    }
    return out;
}

/// Roots on that square; root i does not depend on the count.
inline Roots plane_roots(std::size_t count, unsigned seed, float side = 10) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(0, side);
    Roots out;
    for (std::size_t i = 0; i < count; ++i) {
        const float x = place(random), y = place(random);
        out.positions.emplace_back(x, y, 0.0f);
        out.normals.push_back(Vec3f::UnitZ());
    }
    return out;
}

/// Children at the guides' roots.
inline Roots guide_roots(const StandingGuides& standing) {
    Roots out;
    for (const Vec3& p : standing.guides.root_positions) {
        out.positions.push_back(p.cast<float>());
    }
    out.normals = standing.normals;
    return out;
}

/// One class for all strands, with its kernel.
inline ClassedGuides one_class(const GuideProfiles<float>& profiles,
                               std::span<const Vec3f> normals, Blend blend) {
    ClassedGuides out;
    out.classes.counts = {profiles.count};
    out.profiles.push_back(profiles);
    out.kernels.push_back(kernel_guides(profiles, normals, blend));
    return out;
}

/// Random guides and children, ready to expand.
struct MadeHair {
    StandingGuides standing;
    Binding binding;
    GuideProfiles<float> profiles;

    MadeHair(std::size_t children, int intervals, unsigned seed, int neighbours = 4,
             int segments = 4, double curvature = 0.3)
        : standing(standing_guides(30, segments, seed, curvature)),
          binding(bind(plane_roots(children, seed + 1), standing.guides, standing.normals,
                       {.neighbours = neighbours})),
          profiles(guide_profiles<float>(standing.guides, intervals)) {}

    KernelGuides kernel(Blend blend) const {
        return kernel_guides(profiles, standing.normals, blend);
    }
    ClassedGuides classed(Blend blend) const {
        return one_class(profiles, standing.normals, blend);
    }
};

}  // namespace lancret::test
