#include "guides/files/obj_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <random>
#include <stdexcept>

#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

using testing::HasSubstr;

struct ObjFile : testing::Test {
    TemporaryFolder folder;

    TriangleMesh read(std::string_view text) {
        write_bytes(folder / "a.obj", text);
        return read_obj(folder / "a.obj");
    }
    std::string error_of(std::string_view text) {
        return input_error([&] { read(text); });
    }
};

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

double area(const TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const Vec3f p = mesh.positions[t[0]];
        sum += (mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p).norm() / 2;
    }
    return sum;
}

TEST_F(ObjFile, CutsPolygonsIntoTriangles) {
    const TriangleMesh square = read(kSquare + "f 1 2 3 4\n");
    EXPECT_EQ(square.triangles.size(), 2u);
    EXPECT_FLOAT_EQ(area(square), 1);
    EXPECT_TRUE(square.uvs.empty());
    // A concave L of area 3: a fan from its first corner would cover more.
    const TriangleMesh ell =
        read("v 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\nf 1 2 3 4 5 6\n");
    EXPECT_EQ(ell.triangles.size(), 4u);
    EXPECT_FLOAT_EQ(area(ell), 3);
}

TEST_F(ObjFile, MergesShapesAndReadsCornersOfEveryForm) {
    const TriangleMesh mesh =
        read("# comment\r\nmtllib none.mtl\no one\n" + kSquare +
             "vt 0.25 0.5\nvt 0.75 0.5 0\nvn 0 0 1\nusemtl m\nf 1/1/1 2/2/1 3/-1/-1\r\n"
             "o two\ng x\nl 1 2\nf -4//1 -2//1 -1//1\n");
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(mesh.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
    ASSERT_EQ(mesh.uvs.size(), 2u);
    EXPECT_EQ(mesh.uvs[0][0], Vec2f(0.25f, 0.5f));
    EXPECT_EQ(mesh.uvs[0][2], Vec2f(0.75f, 0.5f));
    EXPECT_EQ(mesh.uvs[1][1], Vec2f::Zero());
}

TEST_F(ObjFile, NamesTheLineOfAnError) {
    const std::pair<const char*, const char*> cases[] = {
        {"v nan 0 0\n", ":5: invalid vertex (nan, 0, 0)"},
        {"v 1e999 0 0\n", ":5: '1e999' in the vertex is not a number"},
        {"v 1e30 0 0\n", ":5: invalid vertex (1e+30, 0, 0)"},
        {"v 1 2\n", ":5: a number of the vertex is missing"},
        {"v 1 2 x\n", ":5: 'x' in the vertex is not a number"},
        {"vt inf 0\n", ":5: the texture coordinate is not finite"},
        {"f 1 2\n", ":5: a face has 2 corners"},
        {"f 1 2 5\n", ":5: index 5 of a vertex, but there are 4"},
        {"f 1 2 0\n", ":5: index 0 of a vertex, but there are 4"},
        {"f 1 2 -5\n", ":5: index -5 of a vertex, but there are 4"},
        {"f 1/1 2/1 3/1\n", ":5: index 1 of a texture coordinate, but there are 0"},
        {"f 1 2 99999999999999999999\n", ":5: the index of a vertex is not a number"},
        {"f 1 2 3x\n", ":5: '3x' is not a corner"},
        {"f 1//0 2//1 3//1\n", ":5: '1//0' is not a corner"},
    };
    for (const auto& [line, expected] : cases) {
        EXPECT_THAT(error_of(kSquare + line + "f 1 2 3\n"), HasSubstr(expected)) << line;
    }
    std::string face = "f";
    for (int i = 0; i < 1001; ++i) face += " 1";
    EXPECT_THAT(error_of(kSquare + face), HasSubstr(":5: a face has more than 1000"));
}

TEST_F(ObjFile, AMeshWithoutTrianglesIsAnError) {
    EXPECT_THAT(error_of(""), HasSubstr("a.obj: no triangles"));
    EXPECT_THAT(error_of(kSquare), HasSubstr("a.obj: no triangles"));
    EXPECT_THAT(input_error([&] { read_obj(folder / "none.obj"); }),
                HasSubstr("there is no such file"));
    EXPECT_THAT(input_error([&] { read_obj(folder.path); }),
                HasSubstr("not a regular file"));
}

TEST_F(ObjFile, TrianglesWithoutAreaAreKept) {
    EXPECT_EQ(read(kSquare + "f 1 1 2\nf 1 2 3\n").triangles.size(), 2u);
}

TEST_F(ObjFile, RoundTripIsExact) {
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    TriangleMesh mesh;
    for (int i = 0; i < 300; ++i) {
        mesh.positions.emplace_back(normal(random), 1e-20f * normal(random),
                                    1e5f * normal(random));
    }
    for (int i = 0; i < 500; ++i) {
        mesh.triangles.push_back({std::uint32_t(random() % 300),
                                  std::uint32_t(random() % 300),
                                  std::uint32_t(random() % 300)});
        const Vec2f shared(0.5f, normal(random));
        mesh.uvs.push_back({shared, Vec2f(normal(random), -0.0f), shared});
    }
    for (const bool uvs : {true, false}) {
        if (!uvs) mesh.uvs.clear();
        write_obj(folder / "b.obj", mesh);
        const TriangleMesh back = read_obj(folder / "b.obj");
        EXPECT_EQ(back.positions, mesh.positions);
        EXPECT_EQ(back.triangles, mesh.triangles);
        EXPECT_EQ(back.uvs, mesh.uvs);
    }
    mesh.uvs.resize(3);
    EXPECT_THROW(write_obj(folder / "b.obj", mesh), std::invalid_argument);
}

TEST_F(ObjFile, AnyFlippedBytesParseOrAreAnInputError) {
    const std::string good = kSquare +
                             "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
                             "f 1/1/1 2/2/1 3/3/1 4/4/1\nf 1 2 3\nf 1//1 -1//1 2//1\n";
    std::mt19937 random(2);
    int parsed = 0;
    for (int i = 0; i < 5000; ++i) {
        std::string bytes = good;
        for (unsigned flips = 1 + random() % 4; flips > 0; --flips) {
            const char kLikely[] = "0123456789-+./ \n\rvftne";
            bytes[random() % bytes.size()] =
                random() % 4 ? kLikely[random() % (sizeof kLikely - 1)] : char(random());
        }
        try {
            const TriangleMesh mesh = read(bytes);
            ++parsed;
            for (const auto& t : mesh.triangles) {
                for (const auto v : t) ASSERT_LT(v, mesh.positions.size());
            }
            for (const Vec3f& p : mesh.positions) ASSERT_TRUE(p.allFinite());
        } catch (const InputError&) {
        }
    }
    EXPECT_GT(parsed, 500);
    EXPECT_LT(parsed, 4500);
}

TEST_F(ObjFile, ReadsARealHead) {
    const std::filesystem::path head =
        LANCRET_SOURCE_DIR "/../shared/data/sintel_head.obj";
    if (!std::filesystem::exists(head)) GTEST_SKIP() << "there is no " << head;
    const TriangleMesh mesh = read_obj(head);
    EXPECT_EQ(mesh.positions.size(), 3046u);
    EXPECT_EQ(mesh.uvs.size(), mesh.triangles.size());
    EXPECT_GT(mesh.triangles.size(), 3046u);
}

}  // namespace
}  // namespace lancret
