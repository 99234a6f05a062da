#include "sim/restart_arrays.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/sim/small_scenes.h"

namespace lancret {
namespace {

/// A busy simulation in the middle of its motion.
struct Midway {
    BusyScene busy;
    Simulation simulation = busy.simulation();

    Midway() {
        for (int frame = 1; frame < 6; ++frame) simulation.advance();
    }
    void resumes(const RestartArrays& arrays) {
        Simulation other = busy.simulation();
        other.resume(6, simulation.guides(), arrays);
    }
};

TEST(RestartArrays, MissingShortAndLongArraysAreRejected) {
    Midway midway;
    const RestartArrays arrays = midway.simulation.restart();
    midway.resumes(arrays);
    ASSERT_EQ(arrays.size(), 6u);
    for (const auto& [name, values] : arrays) {
        ASSERT_FALSE(values.empty()) << name;
        RestartArrays damaged = arrays;
        damaged.erase(name);
        EXPECT_THROW(midway.resumes(damaged), std::invalid_argument) << name;
        damaged[name] = {};
        EXPECT_THROW(midway.resumes(damaged), std::invalid_argument) << name;
        damaged[name] = values;
        damaged[name].pop_back();
        EXPECT_THROW(midway.resumes(damaged), std::invalid_argument) << name;
        damaged[name] = values;
        damaged[name].push_back(0);
        EXPECT_THROW(midway.resumes(damaged), std::invalid_argument) << name;
        damaged[name] = values;
        damaged[name][values.size() / 2] = std::nan("");
        EXPECT_THROW(midway.resumes(damaged), std::invalid_argument) << name;
    }
}

TEST(RestartArrays, InvalidNumbersAreRejected) {
    Midway midway;
    const RestartArrays arrays = midway.simulation.restart();
    const auto refuses = [&](const char* name, std::size_t at, double value) {
        RestartArrays damaged = arrays;
        damaged.at(name).at(at) = value;
        EXPECT_THROW(midway.resumes(damaged), std::invalid_argument)
            << name << " " << at << " " << value;
    };
    for (const double level : {-1., 0.5, 21., 1e300}) refuses("halvings", 0, level);
    // A past: size, step, poses.
    for (const double size : {-1., RodPast::kMax + 1., 1.5, 1e300}) {
        refuses("past", 0, size);
    }
    refuses("past", 1, 0);
    refuses("past", 1, -0.01);
    // An anchor: distance, body, triangle.
    for (const double body : {-2., 1., 0.5, 1e18}) refuses("anchors", 1, body);
    for (const double triangle : {-1., 1., 0.5, 4e9}) refuses("anchors", 2, triangle);
    refuses("allowed", 0, -1);
}

TEST(RestartArrays, AnAnchorOnAMeshIsOnATriangleOfIt) {
    Colliders colliders;
    colliders.add(Capsule{});
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    colliders.add(mesh);
    ContactAnchor anchor;
    anchor.body = colliders.nearest({0.2, 0.2, 3}, 9);
    for (std::uint32_t triangle = 0; triangle < 6; ++triangle) {
        anchor.body.collider = 1;
        anchor.body.triangle = triangle;
        RestartArrays arrays;
        write(anchor, arrays["a"]);
        ArrayReader reader(arrays, "a");
        ContactAnchor back;
        if (triangle < 4) {
            read(reader, colliders, back);
            EXPECT_EQ(back.body.triangle, triangle);
            EXPECT_EQ(back.body.collider, 1);
            EXPECT_TRUE(reader.done());
        } else {
            EXPECT_THROW(read(reader, colliders, back), std::invalid_argument);
        }
    }
}

TEST(RestartArrays, OtherGuidesDoNotResume) {
    Midway midway;
    Simulation other = midway.busy.simulation();
    const RestartArrays arrays = midway.simulation.restart();
    EXPECT_THROW(other.resume(6, hanging_groom(23, 6, 9), arrays), std::invalid_argument);
    EXPECT_THROW(other.resume(6, hanging_groom(24, 5, 9), arrays), std::invalid_argument);
    EXPECT_THROW(other.resume(6, hanging_groom(24, 6, 8), arrays), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
