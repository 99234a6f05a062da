// lancret preview: a groom in, a picture out.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numbers>

#include "guides/errors.h"
#include "procedural/check_figures.h"
#include "tools/command.h"
#include "tools/frames.h"
#include "tools/lod.h"
#include "tools/preview_picture.h"
#include "tools/stats.h"

namespace lancret {

namespace {

struct PreviewOptions {
    GroomOptions groom;
    FrameOptions frames;
    std::string size, shutter, output, deep;
    std::optional<int> samples, motion_samples, turntable;
    std::optional<float> regularisation, noise;
    std::optional<double> lod;
    bool progressive = false, denoise = false;
};

/// The pictures to write: one a frame, or one a view of a turntable.
std::vector<PictureFiles> outputs_of(const PreviewOptions& options, const Job& job,
                                     const ChosenFrames& chosen) {
    std::vector<PictureFiles> out;
    const bool several = chosen.frames.size() > 1;
    if (options.turntable && several) {
        throw InputError(
            "--turntable: goes round one frame; give --frame and not --frames");
    }
    if (options.progressive && !options.deep.empty()) {
        throw InputError("--deep: is written once, at the end; leave out --progressive");
    }
    const auto add = [&](const auto& path_of) {
        out.push_back({path_of(options.output), options.deep.empty()
                                                    ? std::filesystem::path()
                                                    : path_of(options.deep)});
    };
    for (int view = 1; view <= options.turntable.value_or(0); ++view) {
        add([&](const std::string& name) { return picture_path(name, view, true); });
    }
    for (const double frame : chosen.frames) {
        if (options.turntable) break;
        add([&](const std::string& name) {
            return options.frames.given() ? picture_path(name, frame, several)
                                          : std::filesystem::path(name);
        });
    }
    for (const auto& [picture, deep] : out) {
        check_output(picture, {".exr", ".png"}, options.groom, job.groom);
        check_output(deep, {".exr"}, options.groom, job.groom, picture);
        check_output(options.groom.stats, {}, options.groom, job.groom, picture);
        check_output(options.groom.stats, {}, options.groom, job.groom, deep);
    }
    return out;
}

/// "0,0.5" or "-0.25,0.25". Throws InputError.
Vec2 parse_shutter(const std::string& text) {
    Vec2 out;
    const std::size_t comma = std::min(text.find(','), text.size());
    const bool good = CLI::detail::lexical_cast(text.substr(0, comma), out.x()) &&
                      comma < text.size() &&
                      CLI::detail::lexical_cast(text.substr(comma + 1), out.y());
    if (!good || !is_shutter(out)) {
        throw InputError(fmt::format(
            "--shutter: '{}' is no shutter; give when it opens and closes, in frames "
            "after the frame, such as 0,0.5",
            text));
    }
    return out;
}

/// The options laid over what the groom says of its picture.
void lay_over(const PreviewOptions& options, const ChosenFrames& chosen,
              PreviewSettings& settings) {
    RenderSettings& render = settings.render;
    if (!options.size.empty()) {
        std::tie(render.width, render.height) = parse_size(options.size);
    }
    settings.denoise = options.denoise;
    if (options.samples) render.samples = *options.samples;
    if (options.noise) {
        render.noise = *options.noise;
        if (!options.samples) render.samples = kMostAdaptiveSamples;
    }
    if (options.denoise && render.samples < 2) {
        throw InputError(
            "--denoise: one sample a pixel does not tell what is noise; give --samples 2 "
            "or more");
    }
    if (options.regularisation) settings.regularisation = *options.regularisation;
    if (options.motion_samples) settings.motion_samples = *options.motion_samples;
    if (options.shutter.empty()) return;
    settings.shutter = parse_shutter(options.shutter);
    if (chosen.cache.empty()) {
        throw InputError(
            "--shutter: the groom is no cache (.h5) and so holds still; simulate one");
    }
}

int preview(const PreviewOptions& options) {
    const std::size_t before = peak_rss();
    Job job = read_job(options.groom);
    const ChosenFrames chosen = chosen_frames(options.frames, job, false);
    const auto outputs = outputs_of(options, job, chosen);
    lay_over(options, chosen, job.preview);
    const RenderSettings& settings = job.preview.render;

    Generator generator = run_generator(job.groom);
    RestPlaces rest = prepare_frames(generator, chosen, job);
    const Vec3f up = job.groom.scene.up.cast<float>();
    // The camera looks at the rest pose and stays there, whatever frame is shown.
    const Eigen::AlignedBox3f box =
        extent(generator.profiles, generator.source.guides, job.groom.bind.length_scale);
    const Camera front = preview_camera(job.preview, box, up);
    RenderScene scene;
    scene.hair = HairLook(job.preview.hair);
    scene.later_hair = later_hair(job.preview);
    scene.mesh = job.preview.mesh;
    std::vector<Camera> cameras{front};  // or one a view of a turntable
    if (options.turntable) cameras.resize(outputs.size());
    for (std::size_t view = 0; options.turntable && view < outputs.size(); ++view) {
        const float step = 2 * std::numbers::pi_v<float> / float(outputs.size());
        cameras[view] = turned(front, box.center(), up, float(view) * step);
    }

    if (options.lod) {
        prune_by_size(generator, cameras, settings.height, *options.lod);
        rest = rest_places(generator.binding, generator.source);
    }

    nlohmann::json stats = generator_stats(generator), frames = nlohmann::json::array();
    PictureCost total;
    std::vector<ShownTime> moments;
    std::vector<SceneTime> shown;
    std::optional<HairScene> geometry;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const double frame = chosen.frames[options.turntable ? 0 : i];
        const ShutterTimes times =
            shutter_times(chosen, frame, job.preview.shutter, job.preview.motion_samples);
        if (times.cut) {
            fmt::print(
                stderr,
                "lancret: warning: frame {}: the cache has frames {} to {}, and the "
                "shutter is cut to {} to {}\n",
                frame, chosen.first(), chosen.last(), times.frames.front(),
                times.frames.back());
        }
        std::string title = "render";
        if (options.turntable) {
            title = fmt::format("view {} of {}", i + 1, outputs.size());
        } else if (outputs.size() > 1) {
            title = fmt::format("frame {} ({} of {})", frame, i + 1, outputs.size());
        }
        PictureCost cost;
        // Views of a turntable share all but the camera.
        if (!geometry || !options.turntable) {
            geometry.reset();
            geometry.emplace(grow(generator, rest, chosen, times.frames, job, cameras,
                                  moments, cost,
                                  options.turntable || i + 1 == outputs.size()));
            scene.geometry = &*geometry;
            shown = scene_times(moments);
            scene.times = shown;
        }
        const Camera& camera = cameras[options.turntable ? i : 0];
        scene.lights =
            job.preview.lights ? *job.preview.lights : default_lights(camera.view(), up);
        shoot(scene, camera, job.preview, options.progressive, title, outputs[i], cost);
        total.expand += cost.expand;
        total.bvh += cost.bvh;
        total.render += cost.render;
        total.rays += cost.rays;
        total.paths += cost.paths;
        if (i == 0) total.first = cost.first;
        total.bvh_bytes = std::max(total.bvh_bytes, cost.bvh_bytes);
        frames.push_back(
            {{"frame", frame_json(frame)},
             {"image", outputs[i].picture.string()},
             {"times", times.frames},
             {"seconds",
              {{"expand", cost.expand}, {"bvh", cost.bvh}, {"render", cost.render}}}});
        fmt::print(
            "{}: {} strands between {} guides; load {:.2f} s, fit {:.2f}, bind {:.2f}, "
            "expand {:.3f}, BVH {:.2f}, render {:.1f} ({:.2f} million rays/s); {:.0f} "
            "MB\n",
            outputs[i].picture.string(), moments[0].curves.strands,
            generator.source.guides.size(), generator.seconds.load, generator.seconds.fit,
            generator.seconds.bind, cost.expand, cost.bvh, cost.render,
            1e-6 * double(cost.rays) / cost.render, double(peak_rss()) / 1e6);
        std::fflush(stdout);
    }
    add_curve_stats(stats, moments[0].curves, total.expand);
    stats["seconds"]["bvh"] = total.bvh;
    stats["seconds"]["render"] = total.render;
    stats["seconds"]["first_picture"] = total.first;
    stats["rays"] = total.rays;
    stats["paths"] = total.paths;
    add_memory_stats(stats, moments, total.bvh_bytes, before);
    stats["image"] = {{"width", settings.width},
                      {"height", settings.height},
                      {"samples", settings.samples}};
    if (!chosen.cache.empty() || options.turntable) stats["frames"] = std::move(frames);
    write_stats(options.groom.stats, std::move(stats));
    return kFine;
}

}  // namespace

void add_preview(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<PreviewOptions>();
    CLI::App* command = app.add_subcommand("preview", "Render a picture of a groom");
    add_groom_options(*command, options->groom);
    add_frames_options(*command, options->frames);
    command->add_option("--samples", options->samples, "paths a pixel")
        ->type_name("N")
        ->check(CLI::Range(1, 65536));
    command
        ->add_option("--noise", options->noise,
                     "render until the picture has this relative noise, each pixel with "
                     "as many paths as it needs, at most --samples (1024 by default)")
        ->type_name("N")
        ->check(CLI::Range(0.001, 10.0));
    command
        ->add_option("--lod", options->lod,
                     "level of detail: at most this many strands for each pixel that a "
                     "chunk of hair covers, wider as they are fewer")
        ->type_name("N")
        ->check(CLI::Range(1e-6, 1e6));
    command->add_option("--size", options->size, "of the picture, pixels")
        ->type_name("WxH")
        ->check(not_empty());
    command
        ->add_option("--shutter", options->shutter,
                     "motion blur: when it opens and closes, in frames after the frame")
        ->type_name("A,B")
        ->check(not_empty());
    command
        ->add_option("--motion-samples", options->motion_samples,
                     "times in the shutter at which the strands are grown")
        ->type_name("N")
        ->check(CLI::Range(2, int(kMostSceneTimes)));
    command
        ->add_option("--regularisation", options->regularisation,
                     "least roughness of hair after a path's first scattering: less "
                     "noise, a little brighter; 0.5 by default, 0 for a reference")
        ->type_name("R")
        ->check(CLI::Range(0.0, 1.0));
    command->add_flag("--progressive", options->progressive,
                      "write the picture at 1, 2, 4, ... samples a pixel");
    command
        ->add_option("--turntable", options->turntable,
                     "views evenly round the groom, grown once; numbers the pictures")
        ->type_name("N")
        ->check(CLI::Range(2, 100000));
    command->add_flag("--denoise", options->denoise,
                      "less noise of few samples, by a filter that coverage, normals, "
                      "tangents and depth guide");
    command
        ->add_option("--deep", options->deep,
                     "beside the picture a deep one (.exr): strands at their depths")
        ->type_name("FILE")
        ->check(not_empty());
    command
        ->add_option("-o,--output", options->output,
                     "the picture: .exr or .png; of several frames, head.####.png")
        ->required()
        ->type_name("FILE")
        ->check(not_empty());
    command->footer(
        "Examples:\n"
        "  lancret preview examples/made_groom.toml -o head.png\n"
        "  lancret preview groom.hair --scalp head.obj --guides 400 --strands 100000 -o "
        "head.exr\n"
        "  lancret preview cache.h5 --frames 1-96 -o head.####.png\n"
        "  lancret preview cache.h5 --frame 12 --shutter 0,0.5 -o blurred.png\n"
        "  lancret preview groom.toml --turntable 48 -o turn.####.png\n"
        "  lancret preview groom.toml --progressive -o window.png\n"
        "  lancret preview groom.toml --noise 0.1 -o even.exr\n"
        "  lancret preview groom.toml -o head.exr --deep head_deep.exr\n"
        "  lancret preview groom.toml --samples 8 --denoise -o draft.png\n"
        "  lancret preview groom.hair --guides 5% --strands 5000 --size 640x640 "
        "--samples 16 "
        "-o quick.png");
    command->callback([options, &exit_code] { exit_code = preview(*options); });
}

}  // namespace lancret
