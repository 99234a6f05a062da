#include "guides/motion/mesh_sequence.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <stdexcept>

#include "guides/files/obj_file.h"
#include "tests/guides/base/finite_difference.h"
#include "tests/guides/base/temporary_folder.h"
#include "tests/guides/mesh/meshes.h"

namespace lancret {
namespace {

/// A square that bends in time; vertex heights are a polynomial of the frame.
TriangleMesh bent(int frame, float factor) {
    return grid_mesh(3, 3, [=](float u, float v) {
        return Vec3f(u, v, factor * float(frame) * float(frame) * u * (1 + v));
    });
}

ObjSequence write_sequence(const TemporaryFolder& folder, int first, int last) {
    for (int f = first; f <= last; ++f) {
        write_obj(folder / fmt::format("head.{:04}.obj", f), bent(f, 0.125f));
    }
    return {(folder / "head.%04d.obj").string(), first, last, 1, 24};
}

TEST(MeshSequence, FramePathsHaveTheDigitsOfThePattern) {
    EXPECT_EQ(frame_path("a/head.%04d.obj", 7), "a/head.0007.obj");
    EXPECT_EQ(frame_path("head.####.obj", 12345), "head.12345.obj");
    EXPECT_EQ(frame_path("head.#.obj", 3), "head.3.obj");
    EXPECT_EQ(frame_path("head%d.obj", 12), "head12.obj");
    EXPECT_EQ(frame_path("take#2/%d/h.#.obj", 7), "take#2/%d/h.7.obj");
    EXPECT_EQ(frame_path("h_%03d", -5), "h_-05");
    EXPECT_EQ(frame_path("100%/{}_%2d", 5), "100%/{}_05");
}

TEST(MeshSequence, RejectsPatternsWithoutExactlyOneField) {
    for (const char* pattern : {"head.obj", "", "%s.obj", "%", "%04", "##.%d", "#_#",
                                "%99999999999999d", "%4d%4d", "##############"}) {
        EXPECT_THROW(frame_path(pattern, 1), InputError) << pattern;
    }
}

TEST(MeshSequence, IsEachFileAtItsFrame) {
    const TemporaryFolder folder;
    const MeshSequence sequence(write_sequence(folder, 3, 9), bent(0, 0));
    for (int f = 3; f <= 9; ++f) {
        const MeshMotion at = sequence.at(f);
        const TriangleMesh expected = bent(f, 0.125f);
        for (std::uint32_t i = 0; i < expected.positions.size(); ++i) {
            EXPECT_EQ(vertex_motion(at, i).position,
                      expected.positions[i].cast<double>());
        }
    }
}

TEST(MeshSequence, ReproducesConstantAccelerationBetweenFrames) {
    // Catmull-Rom is exact for a quadratic if all four files exist. Heights in the files
    // are exact in float except for products of thirds, 1e-7 of 15 cm, times the sizes of
    // rates (at most 4 x 24) and bends (18 x 24^2).
    const TemporaryFolder folder;
    const MeshSequence sequence(write_sequence(folder, 0, 6), bent(0, 0));
    const auto rest = bent(0, 0);
    for (const double f : {1.0, 2.25, 3.5, 4.99}) {
        const MeshMotion at = sequence.at(f);
        for (std::uint32_t i = 0; i < 16; ++i) {
            const VertexMotion m = vertex_motion(at, i);
            const Vec3 p = rest.positions[i].cast<double>();
            const double c = 0.125 * p.x() * (1 + p.y());
            EXPECT_NEAR(m.position.z(), c * f * f, 3e-6);
            EXPECT_NEAR(m.velocity.z(), 2 * c * f * 24, 1e-3);
            EXPECT_NEAR(m.acceleration.z(), 2 * c * 24 * 24, 3e-2);
            EXPECT_NEAR(m.position.x(), p.x(), 1e-12);
        }
    }
}

TEST(MeshSequence, RatesMatchFiniteDifferences) {
    const TemporaryFolder folder;
    const MeshSequence sequence(write_sequence(folder, 0, 4), bent(0, 0));
    for (const double f : {0.3, 0.7, 1.5, 3.6}) {  // cubic pieces: differences are exact
        for (const std::uint32_t i : {5u, 15u}) {
            const VertexMotion m = vertex_motion(sequence.at(f), i);
            const Vec3 v = 24 * finite_difference(
                                    [&](double x) {
                                        return vertex_motion(sequence.at(x), i).position;
                                    },
                                    f, 0.1);
            const Vec3 a = 24 * finite_difference(
                                    [&](double x) {
                                        return vertex_motion(sequence.at(x), i).velocity;
                                    },
                                    f, 0.1);
            EXPECT_LT((v - m.velocity).norm(), 1e-11);
            EXPECT_LT((a - m.acceleration).norm(), 1e-9);
            EXPECT_GT(m.acceleration.norm(), 1);
        }
    }
}

TEST(MeshSequence, IsConstantOutsideItsFrames) {
    const TemporaryFolder folder;
    const MeshSequence sequence(write_sequence(folder, 2, 5), bent(0, 0));
    for (const double f : {-1e300, 1.9, 5.1, 1e300}) {
        const VertexMotion m = vertex_motion(sequence.at(f), 15);
        const VertexMotion end = vertex_motion(sequence.at(f < 3 ? 2 : 5), 15);
        EXPECT_EQ(m.position, end.position);
        EXPECT_EQ(m.velocity, Vec3::Zero());
        EXPECT_EQ(m.acceleration, Vec3::Zero());
    }
    const MeshSequence one({(folder / "head.%04d.obj").string(), 4, 4, 1, 24},
                           bent(0, 0));
    EXPECT_EQ(vertex_motion(one.at(4), 15).position.z(), 0.125 * 16 * 2);
}

TEST(MeshSequence, ScalesTheFilesUnits) {
    const TemporaryFolder folder;
    ObjSequence files = write_sequence(folder, 0, 2);
    files.centimetres_per_unit = 100;
    const MeshSequence sequence(files, bent(0, 0));
    EXPECT_EQ(vertex_motion(sequence.at(2), 15).position, Vec3(100, 100, 100));
    files.centimetres_per_unit = 1e10;
    EXPECT_THROW(MeshSequence(files, bent(0, 0)).at(2), InputError);
}

TEST(MeshSequence, RejectsOtherTopologyByName) {
    const TemporaryFolder folder;
    const ObjSequence files = write_sequence(folder, 0, 5);
    const MeshSequence sequence(files, bent(0, 0));
    write_obj(folder / "head.0005.obj", square_mesh(1, 2));
    const std::string counts = input_error([&] { sequence.at(5); });
    EXPECT_NE(
        counts.find("head.0005.obj: 9 vertices and 8 triangles, expected 16 and 18"),
        std::string::npos)
        << counts;
    TriangleMesh turned = bent(5, 1);
    std::swap(turned.triangles[7][0], turned.triangles[7][1]);
    write_obj(folder / "head.0005.obj", turned);
    const std::string other = input_error([&] { sequence.at(5); });
    EXPECT_NE(other.find("head.0005.obj: triangle 7"), std::string::npos) << other;
    std::filesystem::remove(folder / "head.0005.obj");
    EXPECT_NE(input_error([&] { sequence.at(5); }).find("head.0005.obj"),
              std::string::npos);
    // Frames that do not need the file are unchanged.
    EXPECT_EQ(vertex_motion(sequence.at(2), 15).position.z(), 1);
}

TEST(MeshSequence, RejectsInvalidSequences) {
    EXPECT_THROW(MeshSequence({"a.obj", 0, 1, 1, 24}, bent(0, 0)), InputError);
    EXPECT_THROW(MeshSequence({"a.%d.obj", 2, 1, 1, 24}, bent(0, 0)), InputError);
    EXPECT_THROW(MeshSequence({"a.%d.obj", 0, 1, 0, 24}, bent(0, 0)),
                 std::invalid_argument);
    const MeshSequence none({"/nowhere/a.%d.obj", -2147483647 - 1, -2147483647 - 1}, {});
    EXPECT_THROW(none.at(0), InputError);
    EXPECT_THROW(none.at(std::nan("")), std::invalid_argument);
}

TEST(MeshSequence, IsTheSameFromManyThreads) {
    const TemporaryFolder folder;
    const MeshSequence sequence(write_sequence(folder, 0, 20), bent(0, 0));
    std::vector<double> heights(200);
    tbb::parallel_for(0, 200, [&](int i) {
        heights[std::size_t(i)] =
            vertex_motion(sequence.at((37 * i % 200) / 10.0), 15).position.z();
    });
    for (int i = 0; i < 200; ++i) {
        EXPECT_EQ(heights[std::size_t(i)],
                  vertex_motion(sequence.at((37 * i % 200) / 10.0), 15).position.z());
    }
}

}  // namespace
}  // namespace lancret
