// lancret info: prints what a file contains.

#include "tools/subcommands.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "guides/base/errors.h"
#include "guides/files/guide_cache.h"
#include "guides/files/hair_file.h"
#include "guides/files/obj_file.h"
#include "guides/mesh/scalp.h"
#include "guides/strand/curve.h"
#include "tools/job.h"
#include "tools/options.h"
#include "tools/stats.h"

namespace lancret {

namespace {

void print_box(const std::vector<Vec3f>& points) {
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : points) box.extend(p);
    const Vec3f low = box.min(), high = box.max();
    fmt::print("box: [{:.4g}, {:.4g}, {:.4g}] to [{:.4g}, {:.4g}, {:.4g}]\n", low.x(),
               low.y(), low.z(), high.x(), high.y(), high.z());
}

/// Prints minimum, maximum and median.
void print_range(const char* title, std::vector<double> values, const char* unit) {
    if (values.empty()) return;
    std::ranges::sort(values);
    fmt::print("{}: {:.4g} to {:.4g}, median {:.4g}{}\n", title, values.front(),
               values.back(), values[values.size() / 2], unit);
}

nlohmann::json info_hair(const std::filesystem::path& file) {
    HairReport report;
    const Strands strands = read_hair(file, &report);
    fmt::print("{}\n{} strands, {} points\n", file.string(), strands.size(),
               strands.points.size());
    if (!report.text.empty()) fmt::print("text: {}\n", report.text);
    std::vector<double> points, lengths;
    std::size_t without_length = 0;
    for (std::size_t i = 0; i < strands.size(); ++i) {
        points.push_back(double(strands.strand(i).size()));
        if (const auto curve = strand_curve(strands, i)) {
            lengths.push_back(curve->length());
        } else {
            ++without_length;
        }
    }
    print_range("points per strand", points, "");
    print_range("length", lengths, " cm");
    if (without_length > 0) fmt::print("strands of zero length: {}\n", without_length);
    print_box(strands.points);
    if (strands.thickness.empty()) {
        fmt::print("thickness: {:.4g} cm for all\n", strands.default_thickness);
    } else {
        print_range("thickness", {strands.thickness.begin(), strands.thickness.end()},
                    " cm");
    }
    fmt::print("per point: {}{}{}{}\n", strands.thickness.empty() ? "" : "thickness ",
               strands.transparency.empty() ? "" : "transparency ",
               strands.colours.empty() ? "" : "colour ",
               strands.uvs.empty() ? "" : "uv ");
    for (const std::string& warning : report.warnings) {
        fmt::print("warning: {}\n", warning);
    }
    if (report.dropped_strands > 0) {
        fmt::print("warning: ignored {} strands of one point\n", report.dropped_strands);
    }
    return {{"strands", strands.size()}, {"points", strands.points.size()}};
}

nlohmann::json info_obj(const std::filesystem::path& file) {
    const Scalp scalp = make_scalp(read_obj(file));
    fmt::print("{}\n{} vertices, {} triangles, {} UVs\n", file.string(),
               scalp.mesh.positions.size(), scalp.mesh.triangles.size(),
               scalp.mesh.uvs.empty() ? "without" : "with");
    fmt::print("area: {:.4g} cm^2\n", scalp.area);
    print_box(scalp.mesh.positions);
    return {{"vertices", scalp.mesh.positions.size()},
            {"triangles", scalp.mesh.triangles.size()}};
}

nlohmann::json info_cache(const std::filesystem::path& file) {
    const GuideCacheInfo info = guide_cache_info(file);
    const Guides guides = read_guide_cache(file, 0);
    fmt::print("{}\n{} guides of {} segments, {} frames from {} at {} fps\n",
               file.string(), info.guides, info.segments, info.frames, info.first_frame,
               info.frames_per_second);
    fmt::print("rest pose: {}; {}\n", info.has_rest ? "stored" : "first frame",
               info.has_restart ? "a simulation can continue from the last frame"
                                : "no restart data");
    if (!info.groom.empty()) fmt::print("groom: {}\n", info.groom);
    std::vector<double> lengths;
    for (std::size_t g = 0; g < guides.size(); ++g) {
        lengths.push_back(guide_length(guides, g));
    }
    print_range("length", lengths, " cm");
    return {{"guides", info.guides},
            {"segments", info.segments},
            {"frames", info.frames},
            {"first_frame", info.first_frame},
            {"last_frame", info.first_frame + (info.frames - 1)},
            {"frames_per_second", info.frames_per_second},
            {"groom", info.groom},
            {"rest", info.has_rest},
            {"restart", info.has_restart}};
}

nlohmann::json info_groom(const std::filesystem::path& file) {
    GroomOptions options;
    options.input = file;
    const Job job = read_job(options);
    const GroomSettings& g = job.groom;
    fmt::print("{}\nstrands from {}; {} segments per guide\n", file.string(),
               g.strands_file.empty() ? "Lancret's generator" : g.strands_file.string(),
               g.fit.segments);
    if (!g.scalp_file.empty()) fmt::print("scalp: {}\n", g.scalp_file.string());
    const std::string children = g.strands ? fmt::format("{}", *g.strands)
                                           : "50000 (without a scalp, one per root)";
    fmt::print("{} children, blend {} of {} guides each\n", children,
               blend_name(g.expand.blend), g.bind.neighbours);
    return nlohmann::json::object();
}

int info(const std::filesystem::path& file, const std::filesystem::path& stats_file) {
    const std::string extension = file.extension().string();
    Stopwatch watch;
    nlohmann::json stats;
    if (extension == ".hair") {
        stats = info_hair(file);
    } else if (extension == ".obj") {
        stats = info_obj(file);
    } else if (extension == ".h5") {
        stats = info_cache(file);
    } else if (extension == ".toml") {
        stats = info_groom(file);
    } else {
        throw InputError(
            fmt::format("{}: not a .hair, .obj, .h5 or .toml file", file.string()));
    }
    stats["seconds"]["load"] = watch.lap();
    write_stats(stats_file, std::move(stats));
    return kFine;
}

}  // namespace

void add_info(CLI::App& app, int& exit_code) {
    struct InfoOptions {
        std::filesystem::path file, stats;
    };
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = app.add_subcommand("info", "Print what a file contains");
    command
        ->add_option("file", options->file,
                     "strands (.hair), mesh (.obj), guides (.h5), groom (.toml)")
        ->required()
        ->type_name("FILE");
    command->add_option("--stats", options->stats, "write statistics and timings")
        ->type_name("JSON");
    command->footer("Examples:\n  lancret info groom.hair\n  lancret info guides.h5");
    command->callback(
        [options, &exit_code] { exit_code = info(options->file, options->stats); });
}

}  // namespace lancret
