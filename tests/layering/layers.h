#pragma once
// The rules of the tree as data: which folder may include which, where third parties
// stay, and how large things may be. docs/architecture.md explains them.

#include <cstddef>
#include <string_view>

namespace lancret::layering {

/// The products' top folders, in order. tools/ may include all others, tests/ and bench/
/// everything.
inline constexpr std::string_view kTops[] = {"guides", "sim", "procedural", "render_test",
                                             "tools"};
inline constexpr std::string_view kTestTops[] = {"tests", "bench"};

/// The C interface: any layer of hosts may include it, and it includes nothing.
inline constexpr std::string_view kInterface = "procedural/lancret_procedural.h";
inline constexpr std::string_view kHosts[] = {
    "procedural/abi/", "procedural/adapters/", "render_test/plugin/", "tools/", "tests/",
    "bench/"};

/// A folder of the product, and the folders that it may include besides itself, separated
/// by spaces. Folders come in the order in which a strand travels: each includes folders
/// above it only.
struct Layer {
    std::string_view folder;
    std::string_view may_include;
};

inline constexpr Layer kLayers[] = {
    {"guides/base", ""},
    {"guides/toml", "guides/base"},
    {"guides/helix", "guides/base"},
    {"guides/strand", "guides/base guides/helix"},
    {"guides/frenet", "guides/base guides/helix guides/strand"},
    {"guides/fit", "guides/base guides/helix guides/strand"},
    {"guides/mesh", "guides/base guides/helix"},
    {"guides/files", "guides/base guides/helix guides/strand guides/mesh"},
    {"guides/motion", "guides/base guides/toml guides/helix guides/mesh guides/files"},
    {"guides/bodies",
     "guides/base guides/toml guides/helix guides/mesh guides/files guides/motion"},
    {"guides/made", "guides/base guides/helix guides/strand guides/mesh"},

    {"sim/segment", "guides/base guides/helix"},
    {"sim/rod", "guides/base guides/helix guides/motion sim/segment"},
    {"sim/equilibrium", "guides/base guides/helix sim/segment sim/rod"},
    {"sim/contact", "guides/base guides/helix guides/bodies sim/segment sim/rod"},
    {"sim",
     "guides/base guides/helix guides/files guides/motion guides/bodies "
     "sim/segment sim/rod sim/equilibrium sim/contact"},

    {"procedural/curves", "guides/base guides/helix"},
    {"procedural/blend", "guides/base guides/helix procedural/curves"},
    {"procedural/roots", "guides/base guides/mesh"},
    {"procedural/bind",
     "guides/base guides/helix guides/mesh procedural/blend procedural/roots"},
    {"procedural/kernels",
     "guides/base guides/helix procedural/curves procedural/blend procedural/bind"},
    {"procedural/expand",
     "guides/base guides/helix guides/strand procedural/curves procedural/blend "
     "procedural/bind procedural/kernels"},
    {"procedural/groom",
     "guides/base guides/toml guides/helix guides/strand guides/fit guides/mesh "
     "guides/files "
     "guides/motion guides/made procedural/roots procedural/bind procedural/expand"},
    {"procedural/motion",
     "guides/base guides/mesh guides/files guides/motion procedural/expand "
     "procedural/groom"},
    {"procedural/chunk",
     "guides/base guides/helix procedural/curves procedural/expand procedural/groom"},
    {"procedural/check",
     "guides/base guides/helix guides/motion procedural/curves procedural/blend "
     "procedural/bind "
     "procedural/expand procedural/groom procedural/motion procedural/chunk"},
    {"procedural/evaluate",
     "guides/base guides/helix guides/strand guides/fit guides/mesh guides/made "
     "procedural/blend procedural/bind procedural/expand procedural/groom "
     "procedural/check"},
    {"procedural/abi",
     "guides/base guides/helix guides/strand guides/mesh guides/files guides/motion "
     "guides/toml "
     "procedural/curves procedural/blend procedural/roots procedural/bind "
     "procedural/expand "
     "procedural/groom procedural/motion procedural/chunk procedural/check "
     "procedural/evaluate"},
    {"procedural/adapters", ""},

    {"render_test/sampling", "guides/base"},
    {"render_test/image", "guides/base"},
    {"render_test/files", "guides/base render_test/image"},
    {"render_test/light", "guides/base render_test/sampling render_test/image"},
    {"render_test/scene",
     "guides/base guides/mesh procedural/curves render_test/sampling"},
    {"render_test/material",
     "guides/base render_test/sampling render_test/image render_test/light "
     "render_test/scene"},
    {"render_test/trace",
     "guides/base guides/mesh procedural/curves render_test/sampling render_test/image "
     "render_test/light render_test/scene render_test/material"},
    {"render_test/settings",
     "guides/base guides/toml render_test/sampling render_test/image render_test/files "
     "render_test/light "
     "render_test/scene render_test/material render_test/trace"},
    {"render_test/plugin", "guides/base guides/mesh procedural/curves procedural/bind"},
};

/// Headers that only some files may include.
struct Private {
    std::string_view headers;  ///< beginning of their paths
    std::string_view
        users;  ///< beginnings of the paths of those files, separated by spaces
};

inline constexpr Private kPrivates[] = {
    {"guides/frenet/", "guides/frenet/ tests/"},
    {"guides/toml/",
     "guides/toml/ guides/motion/ guides/bodies/ procedural/groom/ procedural/abi/source "
     "render_test/settings/ tools/ tests/"},
    {"procedural/kernels/", "procedural/kernels/ procedural/expand/ tests/ bench/"},
    {"sim/simulation_state.h", "sim/simulation"},
};

/// Files that may include only some headers, although their layer may include more.
struct Narrow {
    std::string_view files;  ///< beginning of their paths
    std::string_view layer;  ///< only includes that begin like this are judged
    std::string_view
        headers;  ///< beginnings of what they may include of it, separated by spaces
};

inline constexpr Narrow kNarrow[] = {
    // The figures of an evaluation share nothing with what they measure.
    {"procedural/evaluate/strand_figures.", "procedural/",
     "procedural/evaluate/strand_figures.h"},
    {"procedural/evaluate/strand_figures.", "guides/", "guides/base/"},
    // Pictures get their strands from the plugin and in no other way.
    {"tools/preview/", "procedural/",
     "procedural/lancret_procedural.h procedural/curves/ procedural/bind/report.h "
     "procedural/check/strand.h "
     "procedural/check/tolerances.h"},
    {"render_test/plugin/", "procedural/",
     "procedural/lancret_procedural.h procedural/curves/ procedural/bind/report.h"},
};

/// Headers that no file of a picture reaches, by whatever way.
inline constexpr std::string_view kPictures[] = {"render_test/", "tools/preview/"};
inline constexpr std::string_view kGrowers[] = {
    "procedural/groom/ready_groom.h",    "procedural/groom/children.h",
    "procedural/motion/moving_groom.h",  "procedural/chunk/chunk",
    "procedural/motion/posed_binding.h", "procedural/abi/",
};

/// A third party: how its headers begin, and how the files that may include them begin,
/// separated by spaces.
struct ThirdParty {
    std::string_view headers, files;
};

inline constexpr ThirdParty kThirdParties[] = {
    {"embree",
     "render_test/scene/embree_scene. guides/mesh/closest_point. "
     "bench/render_test/bare_embree."},
    {"OpenImageIO OpenEXR Imath Imf Iex",
     "render_test/image/ render_test/files/ procedural/bind/region_map. "
     "tests/render_test/image/ tests/render_test/files/ "
     "tests/procedural/bind/region_map_test. tests/tools/good_runs_test. "
     "tests/tools/view_layers."},
    {"hdf5 H5", "guides/files/guide_cache tests/guides/files/guide_cache"},
    {"tiny_obj_loader", "guides/files/obj_file."},
    {"nanoflann", "guides/base/point_tree.h"},
    {"hwy/", "procedural/kernels/ tests/procedural/kernels/"},
    {"toml", "guides/toml/"},
    {"CLI/", "tools/ bench/render_test/picture_bench. bench/pipeline/pipeline_bench."},
    {"unsupported/", "tests/"},
    {"gtest gmock", "tests/"},
    {"benchmark/", "bench/"},
    {"tbb/", ""},  // oneapi/tbb/ is the one spelling
};

/// Folders of more files than kMaxFiles, and what they may have: the C interface is one
/// room of entry points.
inline constexpr std::size_t kMaxFiles = 24, kMaxInterfaceFiles = 28;

/// Lines of a file of the product, and of a function.
inline constexpr std::size_t kMaxFileLines = 350, kMaxFunctionLines = 60;

/// Sources without a header of their own name: a program's start, and what a list of
/// entry points declares.
inline constexpr std::string_view kWithoutHeader[] = {"tools/main.cpp",
                                                      "procedural/abi/",
                                                      "procedural/adapters/",
                                                      "procedural/kernels/",
                                                      "procedural/blend/",
                                                      "sim/segment/loops_",
                                                      "tools/"};

}  // namespace lancret::layering
