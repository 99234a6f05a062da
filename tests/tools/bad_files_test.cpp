// Damaged files and files of the wrong kind: each is refused with one line that names it.

#include <cstring>
#include <limits>

#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

template <class T>
void overwrite(std::string& bytes, std::size_t at, T value) {
    std::memcpy(&bytes.at(at), &value, sizeof(T));
}

CommandRun expand_of(const std::string& groom) { return lancret({"expand", groom}); }

TEST(BadHairFile, TruncatedIsRefused) {
    const SmallGrooms folder;
    const std::string whole = read_bytes(folder.hair);
    for (const std::size_t size : {std::size_t(128), whole.size() - 1}) {
        const std::string cut = folder.file("cut.hair", whole.substr(0, size));
        EXPECT_THAT(expand_of(cut), refuses_with("cut.hair:byte")) << size;
    }
}

TEST(BadHairFile, InconsistentCountsAreRefused) {
    const SmallGrooms folder;
    for (const std::size_t at : {std::size_t(4), std::size_t(8)}) {  // strands, points
        for (const std::uint32_t count : {24u, 0xffffffffu}) {
            std::string bytes = read_bytes(folder.hair);
            overwrite(bytes, at, count);
            const std::string file = folder.file("counts.hair", bytes);
            EXPECT_THAT(expand_of(file), refuses_with("counts.hair:byte"))
                << at << " " << count;
        }
    }
}

TEST(BadHairFile, LowerCaseMagicIsRefused) {
    const SmallGrooms folder;
    std::string bytes = read_bytes(folder.hair);
    bytes.replace(0, 4, "hair");
    EXPECT_THAT(expand_of(folder.file("lower.hair", bytes)),
                refuses_with("lower.hair:byte 0", "HAIR"));
}

TEST(BadHairFile, PointsThatAreNotFiniteOrTooFarAreRefused) {
    const SmallGrooms folder;
    for (const float x : {std::numeric_limits<float>::quiet_NaN(), 1e30f}) {
        std::string bytes = read_bytes(folder.hair);
        overwrite(bytes, bytes.size() - 4, x);
        EXPECT_THAT(expand_of(folder.file("far.hair", bytes)),
                    refuses_with("far.hair:byte"))
            << x;
    }
}

/// A .hair file whose strands have these many segments each, all points at the origin.
std::string hair_of_segments(const std::vector<std::uint16_t>& segments) {
    std::string bytes(128, '\0');
    std::uint32_t points = 0;
    for (const std::uint16_t n : segments) points += n + 1u;
    bytes.replace(0, 4, "HAIR");
    overwrite(bytes, 4, std::uint32_t(segments.size()));
    overwrite(bytes, 8, points);
    overwrite(bytes, 12, std::uint32_t(3));  // has segments, has points
    for (const std::uint16_t n : segments) {
        bytes.append(reinterpret_cast<const char*>(&n), sizeof n);
    }
    bytes.append(std::size_t(points) * 12, '\0');
    return bytes;
}

TEST(BadHairFile, StrandsOfOnePointOnlyAreRefused) {
    const SmallGrooms folder;
    const std::string file = folder.file("dots.hair", hair_of_segments({0, 0, 0}));
    EXPECT_THAT(expand_of(file), refuses_with("dots.hair"));
}

TEST(BadHairFile, WithoutStrandsIsRefused) {
    const SmallGrooms folder;
    const std::string file = folder.file("empty.hair", hair_of_segments({}));
    EXPECT_THAT(expand_of(file), refuses_with("empty.hair", "strand"));
}

TEST(BadHairFile, StrandsWithoutLengthAreRefused) {
    const SmallGrooms folder;
    const std::string file = folder.file("flat.hair", hair_of_segments({3, 1}));
    EXPECT_THAT(expand_of(file), refuses_with("flat.hair", "length"));
}

TEST(BadFile, MissingIsRefusedByEverySubcommand) {
    const SmallGrooms folder;
    const std::string file = folder.at("none.hair");
    EXPECT_THAT(lancret({"preview", file, "-o", folder.at("a.png")}),
                refuses_with("none.hair"));
    for (const char* command : {"check", "fit"}) {
        EXPECT_THAT(lancret({command, file}), refuses_with("none.hair")) << command;
    }
    for (const char* name : {"none.toml", "none.h5", "none.obj"}) {
        EXPECT_THAT(lancret({"info", folder.at(name)}), refuses_with(name));
    }
    EXPECT_THAT(lancret({"expand", folder.hair, "--scalp", folder.at("none.obj")}),
                refuses_with("none.obj"));
}

TEST(BadFile, FolderIsRefused) {
    const SmallGrooms folder;
    for (const char* name : {"f.hair", "f.toml", "f.h5", "f.obj"}) {
        std::filesystem::create_directory(folder / name);
        EXPECT_THAT(lancret({"info", folder.at(name)}), refuses_with(name));
    }
    EXPECT_THAT(lancret({"expand", folder.hair, "--scalp", folder.at("f.obj")}),
                refuses_with("f.obj"));
}

TEST(BadFile, UnknownExtensionIsRefusedWithTheKnownOnes) {
    const SmallGrooms folder;
    const std::string file = folder.file("groom.abc", "");
    EXPECT_THAT(expand_of(file), refuses_with("groom.abc", ".toml", ".hair", ".h5"));
    EXPECT_THAT(lancret({"info", file}), refuses_with("groom.abc", ".obj"));
}

TEST(BadFile, H5FileThatIsNotACacheIsRefused) {
    const SmallGrooms folder;
    const std::string bytes = read_bytes(folder.hair);
    for (const std::string& contents : {std::string(), bytes}) {
        const std::string file = folder.file("g.h5", contents);
        EXPECT_THAT(lancret({"info", file}), refuses_with("g.h5"));
    }
}

TEST(BadFile, ObjWithBadIndicesIsRefusedWithItsLine) {
    const SmallGrooms folder;
    for (const char* face : {"f 1 2 9", "f 0 1 2", "f 1 2 -9"}) {
        const std::string obj = folder.file(
            "bad.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + face + "\n");
        EXPECT_THAT(lancret({"expand", folder.hair, "--scalp", obj}),
                    refuses_with("bad.obj:4: "))
            << face;
    }
}

TEST(BadFile, ObjThatHairCannotGrowOnIsRefusedByName) {
    const SmallGrooms folder;
    // Three collinear vertices: a triangle without area.
    const std::string line =
        folder.file("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    EXPECT_THAT(lancret({"expand", folder.hair, "--scalp", line}),
                refuses_with("line.obj", "area"));
    // Vertices without triangles.
    const std::string points = folder.file("points.obj", "v 0 0 0\nv 1 0 0\n");
    EXPECT_THAT(lancret({"expand", folder.hair, "--scalp", points}),
                refuses_with("points.obj"));
    // One metre away from the hair, so not the scalp of this groom.
    const std::string away =
        folder.file("away.obj", "v 0 0 100\nv 1 0 100\nv 0 1 100\nf 1 2 3\n");
    EXPECT_THAT(lancret({"expand", folder.hair, "--scalp", away}),
                refuses_with("away.obj", "cm"));
}

TEST(BadFile, MoreChildrenThanRootsNeedAScalp) {
    const SmallGrooms folder;
    EXPECT_THAT(lancret({"expand", folder.hair, "--strands", "26"}),
                refuses_with("lawn.hair", "--scalp", "--strands", "25"));
}

}  // namespace
}  // namespace lancret
