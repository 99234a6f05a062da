// lancret preview: a groom in, a picture out.

#include <fmt/format.h>

#include <memory>

#include "render_test/embree_scene.h"
#include "tools/command.h"
#include "tools/progress.h"
#include "tools/stats.h"

namespace lancret {

namespace {

struct PreviewOptions {
    GroomOptions groom;
    std::string size, output;
    std::optional<int> samples;
};

const TriangleMesh* body_of(const GroomGuides& source) {
    if (source.body) return &*source.body;
    return source.scalp ? &source.scalp->mesh : nullptr;
}

/// The box of the guides: what a groom means to be, whatever a stray child does.
Eigen::AlignedBox3f extent(const GuideProfiles<float>& profiles, const Guides& guides,
                           float length_scale) {
    Eigen::AlignedBox3f box;
    const std::size_t places = profiles.count + 1;
    for (std::size_t g = 0; g < profiles.size(); ++g) {
        const Vec3f root = guides.root_positions[g].cast<float>();
        for (std::size_t i = 0; i < places; ++i) {
            const Vec3f local = length_scale * profiles.positions[g * places + i];
            box.extend(root + profiles.root_frames[g] * local);
        }
    }
    return box;
}

int preview(const PreviewOptions& options) {
    Job job = read_job(options.groom);
    check_output(options.output, {".exr", ".png"}, options.groom, job.groom);
    check_output(options.groom.stats, {}, options.groom, job.groom, options.output);
    RenderSettings& settings = job.preview.render;
    if (!options.size.empty()) {
        std::tie(settings.width, settings.height) = parse_size(options.size);
    }
    if (options.samples) settings.samples = *options.samples;

    const Generator generator = run_generator(job.groom);
    Stopwatch expand_watch;
    const Curves curves = expand(generator.binding, generator.profiles, job.groom.expand);
    const double expand_seconds = expand_watch.lap();

    const HairScene geometry(curves, body_of(generator.source));
    const Vec3f up = job.groom.scene.up.cast<float>();
    const Camera camera = preview_camera(
        job.preview,
        extent(generator.profiles, generator.source.guides, job.groom.bind.length_scale),
        up);
    RenderScene scene;
    scene.geometry = &geometry;
    scene.hair = HairModel(job.preview.hair);
    scene.mesh = job.preview.mesh;
    scene.lights =
        job.preview.lights ? *job.preview.lights : default_lights(camera.view(), up);

    Stopwatch render_watch;
    ProgressBar bar("render");
    const Image image =
        render(scene, camera, settings, [&](double done) { bar.show(done); });
    const double render_seconds = render_watch.lap();
    write_image(options.output, image, job.preview.background);

    nlohmann::json stats = generator_stats(generator);
    add_curve_stats(stats, curves, expand_seconds);
    stats["seconds"]["bvh"] = geometry.build_seconds();
    stats["seconds"]["render"] = render_seconds;
    stats["bytes"]["bvh"] = geometry.bvh_bytes();
    stats["image"] = {{"width", settings.width},
                      {"height", settings.height},
                      {"samples", settings.samples}};
    write_stats(options.groom.stats, std::move(stats));
    fmt::print(
        "{}: {} strands between {} guides; load {:.2f} s, fit {:.2f}, bind {:.2f}, "
        "expand "
        "{:.3f}, BVH {:.2f}, render {:.1f}; {:.0f} MB\n",
        options.output, curves.strands, generator.source.guides.size(),
        generator.seconds.load, generator.seconds.fit, generator.seconds.bind,
        expand_seconds, geometry.build_seconds(), render_seconds,
        double(peak_rss()) / 1e6);
    return kFine;
}

}  // namespace

void add_preview(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<PreviewOptions>();
    CLI::App* command = app.add_subcommand("preview", "Render a picture of a groom");
    add_groom_options(*command, options->groom);
    command->add_option("--samples", options->samples, "paths a pixel")
        ->type_name("N")
        ->check(CLI::Range(1, 65536));
    command->add_option("--size", options->size, "of the picture, pixels")
        ->type_name("WxH")
        ->check(not_empty());
    command->add_option("-o,--output", options->output, "the picture: .exr or .png")
        ->required()
        ->type_name("FILE")
        ->check(not_empty());
    command->footer(
        "Examples:\n"
        "  lancret preview examples/made_groom.toml -o head.png\n"
        "  lancret preview groom.hair --scalp head.obj --guides 400 --strands 100000 -o "
        "head.exr\n"
        "  lancret preview groom.hair --guides 5% --strands 5000 --size 640x640 "
        "--samples 16 "
        "-o quick.png");
    command->callback([options, &exit_code] { exit_code = preview(*options); });
}

}  // namespace lancret
