// lancret_picture_bench: cost and noise of a picture, from strands in memory. A separate
// program, because it needs a reference picture.

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <vector>

#include "bench/render_test/bare_embree.h"
#include "bench/render_test/sphere_scene.h"
#include "guides/base/stopwatch.h"
#include "render_test/files/write_image.h"
#include "render_test/sampling/sampling.h"
#include "render_test/trace/render.h"

namespace lancret::bench {
namespace {

struct Options {
    std::string scene = "A";
    int threads = 2, tessellation = 1, reference_samples = 1024;
    float eumelanin = 1.3f, regularisation = 0;
    RenderSettings render;
    bool tiles = false;
    std::string reference, picture, lobes = "near";
};

double user_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_utime.tv_sec) + 1e-6 * double(usage.ru_utime.tv_usec);
}

/// Memory of this process, bytes: "VmRSS" now, "VmHWM" at peak.
double memory(const std::string& field) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(field + ":")) return 1024 * std::stod(line.substr(6));
    }
    return 0;
}

/// Pixels on which noise and rays are measured: a grid of 8 x 4 squares of 16 x 16
/// pixels, in the order of a render.
std::vector<Eigen::Vector2i> measured_pixels() {
    std::vector<Eigen::Vector2i> pixels;
    for (int tile = 0; tile < 32; ++tile) {
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
                pixels.emplace_back(tile % 8 * 64 + 24 + x, tile / 8 * 128 + 56 + y);
            }
        }
    }
    return pixels;
}

struct Traced {
    Eigen::Vector4f rgba = Eigen::Vector4f::Zero();  ///< mean
    std::uint64_t rays = 0;
};

/// Traces a pixel as `render` does.
Traced trace_pixel(const SphereScene& made, const RenderSettings& settings,
                   const Eigen::Vector2i& pixel) {
    Traced out;
    for (int s = 0; s < settings.samples; ++s) {
        Sampler sampler(settings.seed, std::uint32_t(512 * pixel.y() + pixel.x()),
                        std::uint32_t(s));
        const Vec2f place = (pixel.cast<float>() + sampler.next()) / 512;
        sampler.skip_to(2);
        const PathResult path =
            trace_path(made.scene, settings.path, made.camera.ray(place), sampler);
        out.rgba.head<3>() += path.radiance;
        out.rgba.w() += path.coverage;
        out.rays += path.rays;
    }
    out.rgba /= float(settings.samples);
    return out;
}

/// Luminance and coverage of the measured pixels at many samples, without regularisation;
/// read from the reference file if it exists, else written to it.
std::vector<Eigen::Vector2f> reference_of(SphereScene& made, const Options& options) {
    made.scene.later_hair.reset();
    const auto pixels = measured_pixels();
    std::vector<Eigen::Vector2f> out(pixels.size());
    const auto bytes = std::streamsize(out.size() * sizeof(out[0]));
    if (std::ifstream in(options.reference, std::ios::binary); in) {
        if (in.read(reinterpret_cast<char*>(out.data()), bytes)) return out;
    }
    RenderSettings many;
    many.samples = options.reference_samples;
    many.seed = options.render.seed + 1;
    many.path.max_depth = options.render.path.max_depth;
    tbb::parallel_for(std::size_t(0), pixels.size(), [&](std::size_t i) {
        const Traced traced = trace_pixel(made, many, pixels[i]);
        out[i] = {luminance(traced.rgba.head<3>()), traced.rgba.w()};
    });
    std::ofstream(options.reference, std::ios::binary)
        .write(reinterpret_cast<const char*>(out.data()), bytes);
    return out;
}

/// Prints the noise: root mean square error of luminance over mean luminance, for pixels
/// at least half covered in the reference.
void print_noise(const std::vector<Eigen::Vector2f>& reference,
                 const std::vector<Eigen::Vector4f>& rgba, double seconds) {
    double squares = 0, sum = 0, mean = 0, count = 0;
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        if (reference[i].y() < 0.5f) continue;
        const double measured = luminance(rgba[i].head<3>()), truth = reference[i].x();
        squares += (measured - truth) * (measured - truth);
        sum += measured, mean += truth, count += 1;
    }
    const double noise = std::sqrt(squares / count) / (mean / count);
    std::printf("noise %.4f, brightness %+.2f %%; noise^2 x CPU seconds %.4f\n", noise,
                100 * (sum / mean - 1), noise * noise * seconds);
}

/// Measures on one thread: noise, and the speed relative to bare Embree.
void measure(SphereScene& made, const Options& options) {
    const auto pixels = measured_pixels();
    std::vector<Traced> traced(pixels.size());
    std::vector<TracedRay> rays;
    RenderSettings settings = options.render;
    settings.path.pixel_angle = 2 * made.camera.tangent / 512;
    const auto trace = [&] {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            traced[i] = trace_pixel(made, settings, pixels[i]);
        }
    };
    settings.path.record = &rays;
    settings.samples = std::min(settings.samples, 16);
    trace();
    settings.path.record = nullptr;
    const BareEmbree bare(made.curves, made.mesh, options.tessellation);
    double path_tracer = 0, embree = 0;
    std::size_t hits = 0;
    for (int pass = 0; pass < 2; ++pass) {
        double start = user_seconds();
        trace();
        path_tracer += user_seconds() - start;
        start = user_seconds();
        hits = bare.trace(rays);
        embree += user_seconds() - start;
    }
    const double count = 2e-6 * double(rays.size());
    std::printf(
        "one thread, %.3f M rays, %.0f %% hit something: %.3f M rays/s of CPU time, "
        "bare Embree %.3f, ratio %.3f\n",
        1e-6 * double(rays.size()), 100.0 * double(hits) / double(rays.size()),
        count / path_tracer, count / embree, embree / path_tracer);
    if (options.reference.empty()) return;
    settings.samples = options.render.samples;
    const double start = user_seconds();
    trace();
    const double seconds = user_seconds() - start;
    std::vector<Eigen::Vector4f> rgba;
    for (const Traced& t : traced) rgba.push_back(t.rgba);
    print_noise(reference_of(made, options), rgba, seconds);
}

/// Cost of building the scene.
struct Start {
    double seconds, user, memory;
};

void render_all(SphereScene& made, const Options& options, const Start& start) {
    Stopwatch watch;
    const double user_before = user_seconds();
    std::uint64_t rays = 0, paths = 0;
    const Image image =
        render(made.scene, made.camera, options.render,
               [&](const RenderProgress& p) { rays = p.rays, paths = p.paths; });
    const double seconds = watch.lap(), user = user_seconds() - user_before;
    std::printf(
        "scene %s, %d threads, %.2f samples: total %.2f s, BVH %.2f s (%.0f MB), render "
        "%.2f s; user BVH %.2f s, render %.2f s\n"
        "%.2f M rays, %.1f per path, %.2f M rays/s of wall time, %.3f M of CPU time; "
        "peak "
        "memory %.0f MB above start\n",
        options.scene.c_str(), options.threads, double(paths) / (512.0 * 512.0),
        start.seconds + seconds, start.seconds,
        double(made.scene.geometry->bvh_bytes()) / 1e6, seconds, start.user, user,
        1e-6 * double(rays), double(rays) / double(paths), 1e-6 * double(rays) / seconds,
        1e-6 * double(rays) / user, (memory("VmHWM") - start.memory) / 1e6);
    if (options.render.noise > 0 && !options.reference.empty()) {
        std::vector<Eigen::Vector4f> rgba;
        for (const Eigen::Vector2i& p : measured_pixels()) {
            rgba.push_back(image.rgba[std::size_t(512) * p.y() + p.x()]);
        }
        print_noise(reference_of(made, options), rgba, user);
    }
    if (!options.picture.empty()) {
        write_image(options.picture, image, Vec3f::Constant(0.18f));
    }
}

int run(Options& options) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      std::size_t(options.threads));
    SphereScene made = sphere_scene(options.scene);
    options.render.path.lobes =
        value_named(kLobeWidthNames, options.lobes).value_or(options.render.path.lobes);
    HairMaterial material;
    material.eumelanin = options.eumelanin;
    made.scene.hair = HairModel(material);
    if (options.regularisation > 0) {
        made.scene.later_hair = HairModel(roughened(material, options.regularisation));
    }
    const double memory_before = memory("VmRSS") - double(made.curves.bytes());
    Stopwatch watch;
    const double user_before = user_seconds();
    HairSceneOptions scene_options;
    scene_options.tessellation = options.tessellation;
    const HairScene geometry(made.curves, &made.mesh, scene_options);
    made.scene.geometry = &geometry;
    const Start start{watch.lap(), user_seconds() - user_before, memory_before};
    if (!options.tiles) render_all(made, options, start);
    if (!(options.render.noise > 0)) measure(made, options);
    return 0;
}

}  // namespace
}  // namespace lancret::bench

int main(int count, char** arguments) {
    lancret::bench::Options options;
    options.render.width = options.render.height = 512;
    options.render.samples = 16;
    CLI::App app("From strands in memory to a picture");
    app.add_option("--scene", options.scene, "A or B");
    app.add_option("--threads", options.threads);
    app.add_option("--samples", options.render.samples);
    app.add_option("--depth", options.render.path.max_depth,
                   "maximum number of scatterings");
    app.add_option("--roulette", options.render.path.roulette_depth);
    app.add_option("--tessellation", options.tessellation);
    app.add_option("--eumelanin", options.eumelanin);
    app.add_option("--regularisation", options.regularisation,
                   "minimum roughness from the second vertex on; 0: off");
    app.add_option(
        "--noise", options.render.noise,
        "target noise of the picture, with at most --samples; 0: --samples everywhere");
    app.add_option("--lobes", options.lobes, "near, far or auto");
    app.add_option("--seed", options.render.seed);
    app.add_option("--reference", options.reference,
                   "reference file; created if missing");
    app.add_flag("--tiles", options.tiles,
                 "measure noise and rays only, without the whole picture");
    app.add_option("--reference-samples", options.reference_samples);
    app.add_option("--picture", options.picture, ".png or .exr");
    CLI11_PARSE(app, count, arguments);
    return lancret::bench::run(options);
}
