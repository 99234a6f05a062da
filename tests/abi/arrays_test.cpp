// Strands and scalps in the memory of the host.

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <limits>

#include "guides/files/hair_file.h"
#include "guides/files/hair_file_write.h"
#include "guides/made/made_groom.h"
#include "tests/abi/plugin.h"

namespace lancret {
namespace {

struct HostArrays {
    std::vector<lancret_u32> counts, corners;
    std::vector<float> points, positions;
    lancret_strands strands{};
    lancret_mesh mesh{};

    HostArrays(const Strands& from, const TriangleMesh& on) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            counts.push_back(lancret_u32(from.strand(i).size()));
        }
        for (const Vec3f& p : from.points) {
            points.insert(points.end(), p.begin(), p.end());
        }
        for (const Vec3f& p : on.positions) {
            positions.insert(positions.end(), p.begin(), p.end());
        }
        for (const auto& t : on.triangles) {
            corners.insert(corners.end(), t.begin(), t.end());
        }
        strands.size = sizeof strands;
        strands.basis = LANCRET_CATMULL_ROM;
        strands.strands = lancret_u32(counts.size());
        strands.counts = counts.data();
        strands.points = points.data();
        mesh.size = sizeof mesh;
        mesh.vertices = lancret_u32(on.positions.size());
        mesh.triangles = lancret_u32(on.triangles.size());
        mesh.positions = positions.data();
        mesh.corners = corners.data();
    }
};

HostArrays made_arrays() {
    MadeGroomSettings settings;
    settings.strands = 150;
    const MadeGroom made = make_groom(settings);
    return {made.strands, made.scalp};
}

lancret_source source_of(const HostArrays& arrays) {
    lancret_source out{};
    out.size = sizeof out;
    out.strands = &arrays.strands;
    return out;
}

TEST(PluginArrays, StrandsAreThoseOfTheSameFile) {
    const HostArrays arrays = made_arrays();
    MadeGroomSettings settings;
    settings.strands = 150;
    const auto path = std::filesystem::temp_directory_path() /
                      ("lancret_abi_" + std::to_string(getpid()) + ".hair");
    write_hair(path, make_groom(settings).strands);
    const std::string name = path.string();
    const auto context = make_context();
    lancret_source file{};
    file.size = sizeof file;
    file.path = name.c_str();
    const Opened from_file = open(context.get(), file);
    std::filesystem::remove(path);
    const Opened from_memory = open(context.get(), source_of(arrays));
    ASSERT_EQ(from_file.status, LANCRET_OK) << from_file.error;
    ASSERT_EQ(from_memory.status, LANCRET_OK) << from_memory.error;
    const auto options = make_options(LANCRET_BSPLINE);
    const auto strands = expanded(from_memory.groom.get(), options);
    EXPECT_EQ(strands.size(), 150u);
    EXPECT_TRUE(strands == expanded(from_file.groom.get(), options));
}

TEST(PluginArrays, HairGrowsOnTheHostsMeshInItsUnit) {
    // The same head in metres, in a scene in metres.
    HostArrays arrays = made_arrays();
    for (float& x : arrays.points) x /= 100;
    for (float& x : arrays.positions) x /= 100;
    lancret_source source = source_of(arrays);
    source.scalp = &arrays.mesh;
    source.text = "[scene]\nmetres_per_unit = 1\n[strands]\ncount = 500\n";
    const auto context = make_context();
    const Opened out = open(context.get(), source);
    ASSERT_EQ(out.status, LANCRET_OK) << out.error;
    EXPECT_EQ(info_of(out.groom.get()).cm_per_unit, 100);
    auto options = make_options(LANCRET_LINEAR);
    options.unit = 100;
    for (const auto& [id, strand] : expanded(out.groom.get(), options)) {
        // On facets of the ellipsoid, which lie up to a few per cent inside it.
        const Vec3 p(strand.positions[0], strand.positions[1], strand.positions[2]);
        EXPECT_NEAR((100 * p).cwiseQuotient(kMadeHead).norm(), 1, 0.03);
    }
}

TEST(PluginArrays, EveryCountAndNumberIsValidated) {
    const auto context = make_context();
    const auto fault = [&](auto change, lancret_status expected) {
        HostArrays arrays = made_arrays();
        lancret_source source = source_of(arrays);
        source.scalp = &arrays.mesh;
        change(arrays);
        const Opened out = open(context.get(), source);
        EXPECT_EQ(out.status, expected) << out.error;
        return out.error;
    };
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(fault([](HostArrays& a) { a.counts[3] = 1; }, LANCRET_BAD_INPUT),
              "strands: strand 3 has 1 points, expected 2 or more");
    EXPECT_EQ(fault(
                  [](HostArrays& a) {
                      a.strands.basis = LANCRET_BSPLINE;
                      a.counts[3] = 3;
                  },
                  LANCRET_BAD_INPUT),
              "strands: strand 3 has 3 points, expected 4 or more");
    EXPECT_NE(fault([&](HostArrays& a) { a.points[10] = kNaN; }, LANCRET_BAD_INPUT)
                  .find("strands: point 3 is at"),
              std::string::npos);
    fault([](HostArrays& a) { a.points[10] = 1e30f; }, LANCRET_BAD_INPUT);
    EXPECT_NE(fault([](HostArrays& a) { a.corners[5] = 1u << 30; }, LANCRET_BAD_INPUT)
                  .find("scalp: triangle 1 has a corner at vertex 1073741824"),
              std::string::npos);
    fault([&](HostArrays& a) { a.positions[0] = kNaN; }, LANCRET_BAD_INPUT);
    fault([](HostArrays& a) { std::ranges::fill(a.positions, 1.0f); }, LANCRET_BAD_INPUT);
    fault([](HostArrays& a) { a.strands.strands = 0; }, LANCRET_BAD_CALL);
    fault([](HostArrays& a) { a.strands.points = nullptr; }, LANCRET_BAD_CALL);
    fault([](HostArrays& a) { a.strands.basis = LANCRET_HERMITE; }, LANCRET_BAD_CALL);
    fault([](HostArrays& a) { a.strands.size = 1; }, LANCRET_BAD_CALL);
    fault([](HostArrays& a) { a.mesh.triangles = 0; }, LANCRET_BAD_CALL);
    fault([](HostArrays&) {}, LANCRET_OK);
}

TEST(PluginArrays, EvaluationReportsEveryBlend) {
    const auto context = make_context();
    std::string text;
    const std::string groom = "[guides]\nmade.strands = 150\n";
    const auto source = text_source(groom);
    char error[256];
    ASSERT_EQ(
        lancret_context_evaluate(
            context.get(), &source,
            [](void* user, const char* json) { *static_cast<std::string*>(user) = json; },
            &text, error, sizeof error),
        LANCRET_OK)
        << error;
    for (const char* part :
         {"\"blends\"", "\"detail\"", "\"position\"", "\"rms_over_length\""}) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
}

}  // namespace
}  // namespace lancret
