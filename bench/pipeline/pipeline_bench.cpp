// lancret_pipeline_bench: a table of all stages from a groom's file to its first picture,
// beside the limits of the machine. The stages are those of `lancret preview`, run once
// for each number of strands. The limits are measured as well: a memory fill, and a
// program that only builds Embree's BVH of the same strands.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "bench/memory_fill.h"
#include "bench/render_test/bare_embree.h"
#include "guides/base/stopwatch.h"
#include "procedural/groom/ready_groom.h"

namespace lancret::bench {
namespace {

/// Points per second of Blender 3.4 on such a machine: 100,000 interpolated children of
/// 17 points between 1,000 guides in 0.187 s.
constexpr double kBlenderPoints = 100'000 * 17 / 0.187;

struct Options {
    std::string program, groom;
    std::vector<std::uint32_t> strands{10'000, 100'000, 1'000'000};
    bool embree = true;
};

/// A folder that the destructor removes.
struct TemporaryFolder {
    std::filesystem::path path;

    TemporaryFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "lancret-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": mkdtemp");
        path = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

std::string quoted(const std::string& text) { return "'" + text + "'"; }

/// The --stats of a picture with `strands` strands.
nlohmann::json picture_stats(const Options& options, std::uint32_t strands) {
    const TemporaryFolder folder;
    const std::string stats = (folder.path / "stats.json").string();
    const std::string command = quoted(options.program) + " preview " +
                                quoted(options.groom) + " --strands " +
                                std::to_string(strands) + " --samples 1 -o " +
                                quoted((folder.path / "picture.exr").string()) +
                                " --stats " + quoted(stats) + " > /dev/null";
    if (std::system(command.c_str()) != 0) {
        throw std::runtime_error("failed: " + command);
    }
    std::ifstream file(stats);
    return nlohmann::json::parse(file);
}

/// Time to build only the BVH of the same strands with Embree, s.
double embree_seconds(const Options& options, std::uint32_t strands) {
    const TomlTable toml = TomlTable::from_file(options.groom);
    GroomSettings groom = read_groom(toml, options.groom);
    groom.strands = strands;
    ReadyGroom ready = make_ready_groom(groom);
    const Curves curves = expand(ready.binding, rest_guides(ready), groom.expand);
    ready.binding = {};
    TriangleMesh unseen;
    unseen.positions = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)};
    unseen.triangles = {{0, 1, 2}};
    Stopwatch watch;
    const BareEmbree bare(curves, unseen, 1);
    return watch.lap();
}

/// `embree` as of embree_seconds, or 0 if it was skipped; `fill` in bytes per second.
void print_row(const nlohmann::json& stats, double fill, double embree) {
    const auto& seconds = stats.at("seconds");
    const auto& bytes = stats.at("bytes");
    const auto s = [&](const char* stage) { return seconds.at(stage).get<double>(); };
    const auto b = [&](const char* part) { return bytes.at(part).get<double>(); };
    const double points = stats.at("points").get<double>() / s("expand");
    const double peak = stats.at("peak_rss").get<double>() - b("process");
    const double required = b("curves") + b("widths") + b("bvh");
    std::printf("| %.0f | %.2f | %.2f | %.2f | %.3f | %.0f | %.3f | %.1f | %.2f | ",
                stats.at("strands").get<double>(), s("load"), s("fit"), s("bind"),
                s("expand"), points / 1e6, b("curves") / s("expand") / fill,
                points / kBlenderPoints, s("bvh"));
    if (embree > 0) std::printf("%.2f", s("bvh") / embree);
    std::printf(" | %.2f | %.0f | %.2f |\n", s("first_picture"), peak / 1e6,
                peak / required);
    std::fflush(stdout);
}

void run(const Options& options) {
    const double fill = fill_bandwidth(2);
    std::printf(
        "A fill writes %.1f GB/s on two threads.\n\n"
        "| strands | load s | fit s | place and bind s | expand s | million points/s | "
        "of the fill | times Blender | BVH s | over bare Embree | first picture s | MB | "
        "over curves and BVH |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
        fill / 1e9);
    for (const std::uint32_t strands : options.strands) {
        const nlohmann::json stats = picture_stats(options, strands);
        print_row(stats, fill, options.embree ? embree_seconds(options, strands) : 0);
    }
}

}  // namespace
}  // namespace lancret::bench

int main(int argc, char** argv) {
    lancret::bench::Options options;
    CLI::App app("Time of each stage from a groom's file to its first picture");
    app.add_option("program", options.program, "the lancret program")->required();
    app.add_option("groom", options.groom, "a groom (.toml)")->required();
    app.add_option("--strands", options.strands, "numbers of strands")->delimiter(',');
    app.add_flag("!--no-embree", options.embree, "skip the comparison with bare Embree");
    CLI11_PARSE(app, argc, argv);
    try {
        lancret::bench::run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "lancret_pipeline_bench: %s\n", error.what());
        return 2;
    }
    return 0;
}
