#include "sim/rod/section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lancret {
namespace {

TEST(RodSection, RoundHairHasTheClosedForm) {
    // E I = E pi r^4 / 4, G J = E / (2 (1 + sigma)) pi r^4 / 2, rho S = rho pi r^2.
    const RodMaterial hair;
    const RodSection section = rod_section(hair, Dissipation::viscoelastic, 0.1);
    const double bending = 4e10 * kPi / 4 * std::pow(0.004, 4);
    EXPECT_NEAR(section.stiffness.y() / bending, 1, 1e-14);
    EXPECT_NEAR(section.stiffness.z() / bending, 1, 1e-14);
    EXPECT_NEAR(section.stiffness.x() / bending, 1 / 1.48, 1e-14);
    EXPECT_NEAR(section.linear_density, 1.3 * kPi * 16e-6, 1e-18);
    EXPECT_TRUE(section.damping.isApprox(0.1 * section.stiffness, 1e-15));
}

TEST(RodSection, FlatHairBendsOverItsThinSide) {
    // k2 bends towards n1 (T' = k2 n1 - k1 n2), across the half axis a1: I ~ a1^3 a2.
    RodMaterial hair;
    hair.radius1 = 0.002;
    hair.radius2 = 0.006;
    const RodSection section = rod_section(hair, Dissipation::uniform, 3);
    EXPECT_NEAR(section.stiffness.y() / section.stiffness.z(), 9, 1e-12);
    EXPECT_EQ(section.damping, Vec3::Constant(3));
    // J = pi a1^3 a2^3 / (a1^2 + a2^2).
    const double torsion = kPi * 8e-9 * 216e-9 / 40e-6;
    EXPECT_NEAR(section.stiffness.x() / (4e10 / 2.96 * torsion), 1, 1e-14);
}

TEST(RodSection, RejectsInvalidMaterials) {
    const auto refuses = [](auto change) {
        RodMaterial hair;
        change(hair);
        EXPECT_THROW(rod_section(hair, Dissipation::uniform, 0), std::invalid_argument);
    };
    refuses([](RodMaterial& h) { h.young_modulus = 0; });
    refuses([](RodMaterial& h) { h.density = std::numeric_limits<double>::quiet_NaN(); });
    refuses([](RodMaterial& h) { h.radius2 = -1; });
    refuses([](RodMaterial& h) { h.radius1 = std::numeric_limits<double>::infinity(); });
    refuses([](RodMaterial& h) { h.poisson_ratio = 0.51; });
    EXPECT_THROW(rod_section({}, Dissipation::uniform, -1), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
