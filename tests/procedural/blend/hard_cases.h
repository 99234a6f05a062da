#pragma once
// Motions of two guides through configurations that are hard for a blend.

#include <functional>

#include "tests/procedural/made_guides.h"

namespace lancret::test {

/// The frame with n0 = `tangent` and n1 as close to z as possible.
inline Mat3 frame_along(const Vec3& tangent) {
    const Vec3 n1 = (Vec3::UnitZ() - tangent * tangent.z()).normalized();
    Mat3 out;
    out << tangent, n1, tangent.cross(n1);
    return out;
}

inline const Mat3 kForward = frame_along(Vec3::UnitX());

/// A motion of two guides of 10 cm in six segments, from time 0 to 1.
struct HardCase {
    const char* name;
    std::function<void(double time, Guides& guides)> add;
};

inline void add_even(Guides& guides, const Vec3& u, const Mat3& frame = kForward) {
    add_guide(guides, std::vector<Vec3>(6, u), 10, frame);
}

inline const HardCase kHardCases[] = {
    {"normals come to oppose",
     [](double t, Guides& out) {
         // An arc turns once about its root tangent; the other guide is at rest.
         const double angle = 2 * kPi * t;
         add_even(out, {0, -0.2 * std::sin(angle), 0.2 * std::cos(angle)});
         add_even(out, {0.05, 0, 0.15});
     }},
    {"straightens, bends back",
     [](double t, Guides& out) {
         add_even(out, {0, 0.01, 0.2 * (1 - 2 * t)});
         add_even(out, {0.05, 0, 0.1});
     }},
    {"straightens exactly",
     [](double t, Guides& out) {
         add_even(out, {0, 0, 0.2 * (1 - 2 * t)});
         add_even(out, {0, 0, 0.1});
     }},
    {"curl reverses",
     [](double t, Guides& out) {
         add_even(out, {1.2 * (1 - 2 * t), 0, 0.8});
         add_even(out, {1.0, 0, 0.7});
     }},
    {"swings through opposite",
     [](double t, Guides& out) {
         const double angle = kPi * (0.75 + 0.5 * t);
         add_even(out, {0, 0, 0.05}, frame_along({std::cos(angle), std::sin(angle), 0}));
         add_even(out, {0, 0.05, 0.05});
     }},
    {"joints appear",
     [](double t, Guides& out) {
         std::vector<Vec3> u;
         for (int q = 0; q < 6; ++q) {
             const double sign = q % 2 ? 1 : -1;
             u.push_back(Vec3(0.2, 0, 0.3) + t * sign * Vec3(0.1, 0.3, -0.1));
         }
         add_guide(out, u, 10, kForward);
         add_even(out, {0.2, 0.1, 0.3});
     }},
};

}  // namespace lancret::test
