// RenderMan's procedural, as seen by a renderer.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/adapters/moving_groom.h"
#include "tests/adapters/rib_host.h"
#include "tests/adapters/rib_reader.h"

namespace lancret {
namespace {

const std::string kDso = LANCRET_RENDERMAN;

/// "file='...' chunk_strands=64 " followed by `rest`.
std::string parameters_of(const std::string& file, const std::string& rest) {
    std::string out = "file='";
    return out.append(file).append("' chunk_strands=64 ").append(rest);
}
std::string parameters_of(const MadeGroom& groom, const std::string& rest) {
    return parameters_of(groom.path, rest);
}
std::string parameters_of(const MovingGroom& groom, const std::string& rest) {
    return parameters_of(groom.cache, rest);
}

struct NamedBasis {
    const char* name;
    int basis;
};
constexpr NamedBasis kBases[] = {{"linear", LANCRET_LINEAR},
                                 {"b-spline", LANCRET_BSPLINE},
                                 {"catmull-rom", LANCRET_CATMULL_ROM},
                                 {"bezier", LANCRET_BEZIER},
                                 {"hermite", LANCRET_HERMITE}};

/// The points that the renderer received, in the form of the C interface: x y z radius.
std::vector<float> abi_points(const RibCurves& curves, bool hermite) {
    const std::vector<float>& points = curves.values.at("P");
    const bool constant = curves.values.contains("constantwidth");
    std::vector<float> out;
    for (std::size_t i = 0; i < points.size() / 3; i += hermite ? 2 : 1) {
        out.insert(out.end(), &points[3 * i], &points[3 * i] + 3);
        out.push_back(constant ? curves.values.at("constantwidth")[0] / 2
                               : curves.values.at("vertex float width")[i] / 2);
    }
    return out;
}

TEST(Renderman, EmitsThePointsAndWidthsOfTheInterfaceInEveryBasis) {
    const MadeGroom made;
    const AbiGroom groom(made.path, 64);
    ASSERT_GT(groom.info.chunks, 1u);
    for (const NamedBasis& basis : kBases) {
        SCOPED_TRACE(basis.name);
        RibHost host(kDso);
        const auto chunks = read_rib(
            host.rib_of(parameters_of(made, "basis=" + std::string(basis.name))));
        ASSERT_EQ(host.errors, "");
        ASSERT_EQ(chunks.size(), groom.info.chunks);
        const bool hermite = basis.basis == LANCRET_HERMITE;
        lancret_u32 strands = 0;
        for (lancret_u32 c = 0; c < groom.info.chunks; ++c) {
            const AbiCurves abi = groom.expand(c, options_at({}, basis.basis));
            ASSERT_EQ(chunks[c].curves.size(), 1u);
            const RibCurves& curves = chunks[c].curves[0];
            std::vector<int> counts(abi.counts.begin(), abi.counts.end());
            if (hermite) {
                for (int& count : counts) count *= 2;
            }
            EXPECT_EQ(curves.counts, counts);
            EXPECT_EQ(curves.type, basis.basis == LANCRET_LINEAR ? "linear" : "cubic");
            EXPECT_EQ(curves.wrap, "nonperiodic");
            EXPECT_EQ(abi_points(curves, hermite), abi.positions[0]);
            strands += lancret_u32(counts.size());
        }
        EXPECT_EQ(strands, groom.info.strands);
    }
}

TEST(Renderman, HermiteCurvesHaveTheTangentsOfTheInterface) {
    const MadeGroom made;
    const AbiGroom groom(made.path, 64);
    RibHost host(kDso);
    const auto chunks = read_rib(host.rib_of(parameters_of(made, "basis=hermite")));
    const AbiCurves abi =
        groom.expand(0, options_at({}, LANCRET_HERMITE, LANCRET_TANGENTS));
    const RibCurves& curves = chunks.at(0).curves.at(0);
    const std::vector<float>& points = curves.values.at("P");
    std::vector<float> tangents;
    for (std::size_t i = 1; i < points.size() / 3; i += 2) {
        tangents.insert(tangents.end(), &points[3 * i], &points[3 * i] + 3);
        tangents.push_back(curves.values.at("vertex float width")[i] / 2);
    }
    EXPECT_EQ(tangents, abi.tangents.at(0));
}

TEST(Renderman, EmitsPrimvarsOfTheirClasses) {
    const MadeGroom made;
    const AbiGroom groom(made.path, 64);
    RibHost host(kDso);
    const auto chunks = read_rib(host.rib_of(
        parameters_of(made, "primvars=id,st,length,guides,arc_length,random,N")));
    ASSERT_EQ(host.errors, "");
    const AbiCurves abi = groom.expand(
        0, options_at({}, LANCRET_BSPLINE,
                      LANCRET_IDS | LANCRET_ROOT_UV | LANCRET_LENGTHS | LANCRET_GUIDES |
                          LANCRET_ARC_LENGTHS | LANCRET_RANDOM | LANCRET_NORMALS));
    const auto& values = chunks.at(0).curves.at(0).values;
    const std::string n = std::to_string(abi.neighbours);
    EXPECT_EQ(values.at("uniform integer id"),
              std::vector<float>(abi.ids.begin(), abi.ids.end()));
    EXPECT_EQ(values.at("uniform float[2] st"), abi.root_uv);
    EXPECT_EQ(values.at("uniform float length"), abi.lengths);
    EXPECT_EQ(values.at("uniform integer[" + n + "] guides"),
              std::vector<float>(abi.guides.begin(), abi.guides.end()));
    EXPECT_EQ(values.at("uniform float[" + n + "] weights"), abi.weights);
    EXPECT_EQ(values.at("vertex float arc_length"), abi.arc_lengths);
    EXPECT_EQ(values.at("uniform float random"), abi.random);
    std::vector<float> normals;
    for (std::size_t i = 0; i < abi.normals.at(0).size(); i += 4) {
        normals.insert(normals.end(), &abi.normals[0][i], &abi.normals[0][i] + 3);
    }
    EXPECT_EQ(values.at("vertex normal N"), normals);
}

/// Largest distance of a chunk's curves, with their widths, outside its bound, cm.
float outside(const RibChunk& chunk) {
    float out = -1e30f;
    for (const RibCurves& curves : chunk.curves) {
        for (const auto& place : places_on(chunk, curves, 8)) {
            for (std::size_t a = 0; a < 3; ++a) {
                out = std::max(out, chunk.bound[2 * a] - (place[a] - place[3]));
                out = std::max(out, place[a] + place[3] - chunk.bound[2 * a + 1]);
            }
        }
    }
    return out;
}

// Curves are evaluated in float, with coordinates below 64 cm: the error of a sum of four
// products is a few times 64 * 2^-24 = 4e-6 cm.
constexpr float kRounding = 2e-5f;

TEST(Renderman, EveryChunkIsInsideItsBound) {
    const MadeGroom made;
    for (const std::string bound : {"reach", "tight"}) {
        for (const NamedBasis& basis : kBases) {
            RibHost host(kDso);
            const auto chunks = read_rib(host.rib_of(
                parameters_of(made, "bound=" + bound + " basis=" + basis.name)));
            ASSERT_GT(chunks.size(), 1u) << host.errors;
            for (const RibChunk& chunk : chunks) {
                EXPECT_LE(outside(chunk), kRounding) << bound << " " << basis.name;
            }
        }
    }
}

TEST(Renderman, BoundsHoldWhatMoves) {
    const MovingGroom moving;
    for (const std::string bound : {"reach", "tight"}) {
        RibHost host(kDso);
        const auto chunks = read_rib(
            host.rib_of(parameters_of(moving, "frame=1 samples=0,0.5,1 bound=" + bound)));
        ASSERT_GT(chunks.size(), 1u) << host.errors;
        for (const RibChunk& chunk : chunks) {
            EXPECT_LE(outside(chunk), kRounding) << bound;
        }
    }
}

TEST(Renderman, MotionBlocksHaveTheirTimesAndTheInterfacesPoints) {
    const MovingGroom moving;
    const AbiGroom groom(moving.cache, 64);
    RibHost host(kDso);
    const auto chunks = read_rib(host.rib_of(
        parameters_of(moving, "frame=1.5 samples=-0.25,0,0.5 motion=0,0.5,1")));
    ASSERT_EQ(host.errors, "");
    ASSERT_EQ(chunks.size(), groom.info.chunks);
    const std::vector<double> times = {1.25, 1.5, 2};
    for (lancret_u32 c = 0; c < groom.info.chunks; ++c) {
        const AbiCurves abi = groom.expand(c, options_at(times, LANCRET_BSPLINE));
        EXPECT_EQ(chunks[c].motion, (std::vector<float>{0, 0.5f, 1}));
        ASSERT_EQ(chunks[c].curves.size(), 3u);
        for (std::size_t t = 0; t < 3; ++t) {
            EXPECT_EQ(abi_points(chunks[c].curves[t], false), abi.positions[t]);
        }
        EXPECT_TRUE(abi.positions[0] != abi.positions[2]) << "static";
    }
}

TEST(Renderman, OneTimeNeedsNoMotionBlock) {
    const MovingGroom moving;
    RibHost host(kDso);
    const auto chunks = read_rib(host.rib_of(parameters_of(moving, "frame=2")));
    ASSERT_GT(chunks.size(), 1u);
    for (const RibChunk& chunk : chunks) {
        EXPECT_TRUE(chunk.motion.empty());
        EXPECT_EQ(chunk.curves.size(), 1u);
    }
}

TEST(Renderman, ParametersOverrideTheGroomsFile) {
    const MadeGroom made;
    RibHost host(kDso);
    std::size_t strands = 0;
    for (const RibChunk& chunk :
         read_rib(host.rib_of(parameters_of(made, "strands.count=123")))) {
        strands += chunk.curves.at(0).counts.size();
    }
    EXPECT_EQ(strands, 123u);
}

struct Amount {
    std::size_t strands = 0;
    float widest = 0;
};

Amount amount_of(const std::vector<RibChunk>& chunks) {
    Amount out;
    for (const RibChunk& chunk : chunks) {
        for (const RibCurves& curves : chunk.curves) {
            out.strands += curves.counts.size();
            const auto constant = curves.values.find("constantwidth");
            for (const float width : constant != curves.values.end()
                                         ? constant->second
                                         : curves.values.at("vertex float width")) {
                out.widest = std::max(out.widest, width);
            }
        }
    }
    return out;
}

TEST(Renderman, GrowsFewerAndWiderStrandsAtSmallDetail) {
    const MadeGroom made;
    const std::string level = "strands_per_pixel=0.5 min_density=0.05";
    RibHost host(kDso);
    const auto all = read_rib(host.rib_of(parameters_of(made, "")));
    const auto unknown = read_rib(host.rib_of(parameters_of(made, level)));
    const auto near = read_rib(host.rib_of(parameters_of(made, level), 1e5f));
    const auto middle = read_rib(host.rib_of(parameters_of(made, level), 64));
    const auto far = read_rib(host.rib_of(parameters_of(made, level), 0));
    ASSERT_EQ(host.errors, "");
    EXPECT_EQ(amount_of(unknown).strands, 300u);  // RI_INFINITY: all strands
    EXPECT_EQ(amount_of(near).strands, 300u);     // up to 50000 per chunk
    // 0.5 * 64 strands per chunk of at most 64.
    EXPECT_LT(amount_of(middle).strands, 250u);
    EXPECT_GT(amount_of(middle).strands, 100u);
    EXPECT_LT(amount_of(far).strands, amount_of(middle).strands);
    EXPECT_GT(amount_of(middle).widest, amount_of(all).widest);
    EXPECT_GT(amount_of(far).widest, amount_of(middle).widest);
    // Bounds are given before the detail is known, and hold at any detail.
    for (const auto& chunks : {unknown, near, middle, far}) {
        for (const RibChunk& chunk : chunks) EXPECT_LE(outside(chunk), kRounding);
    }
}

}  // namespace
}  // namespace lancret
