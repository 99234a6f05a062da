// lancret preview: a groom in, a picture out.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numbers>

#include "guides/base/errors.h"
#include "guides/base/stopwatch.h"
#include "procedural/check/figures.h"
#include "render_test/image/contact_sheet.h"
#include "tools/preview/groom.h"
#include "tools/preview/lod.h"
#include "tools/preview/options.h"
#include "tools/progress.h"
#include "tools/stats.h"
#include "tools/subcommands.h"

namespace lancret {

namespace {

/// One camera for all pictures, or one a view of a turntable. It looks at the rest pose
/// and stays there, whatever frame is shown.
std::vector<Camera> cameras_of(const Job& job, const Eigen::AlignedBox3f& box,
                               std::size_t views) {
    const Vec3f up = job.groom.scene.up.cast<float>();
    const Camera front = preview_camera(job.preview, box, up);
    std::vector<Camera> out(std::max<std::size_t>(views, 1), front);
    for (std::size_t view = 0; view < views; ++view) {
        const float step = 2 * std::numbers::pi_v<float> / float(views);
        out[view] = turned(front, box.center(), up, float(view) * step);
    }
    return out;
}

/// What all pictures took together; of the first one, until it was there.
void add_cost(const PictureCost& cost, bool first, PictureCost& total) {
    total.bind += cost.bind;
    total.expand += cost.expand;
    total.bvh += cost.bvh;
    total.render += cost.render;
    total.rays += cost.rays;
    total.paths += cost.paths;
    if (first) total.first = cost.first;
    total.bvh_bytes = std::max(total.bvh_bytes, cost.bvh_bytes);
}

void print_picture(const std::filesystem::path& output, const nlohmann::json& stats,
                   std::size_t strands, const PictureCost& cost) {
    const nlohmann::json& seconds = stats.at("seconds");
    fmt::print(
        "{}: {} strands between {} guides; load {:.2f} s, fit {:.2f}, bind {:.2f}, "
        "expand {:.3f}, BVH {:.2f}, render {:.1f} ({:.2f} million rays/s); {:.0f} MB\n",
        output.string(), strands, stats.at("guides").get<std::size_t>(),
        seconds.at("load").get<double>(), seconds.at("fit").get<double>(),
        seconds.at("bind").get<double>() + cost.bind, cost.expand, cost.bvh, cost.render,
        cost.render > 0 ? 1e-6 * double(cost.rays) / cost.render : 0.0,
        double(peak_rss()) / 1e6);
}

/// Throws InputError where strands cannot have the faces that elliptic ones need.
void check_faces(const Job& job) {
    if (job.groom.expand.shape.value_or(CurveShape::flat) == CurveShape::flat &&
        job.groom.expand.basis == CurveBasis::bspline) {
        return;
    }
    throw InputError(
        fmt::format("{}: 'aspect' of [material] is of strands that are drawn as 'flat' "
                    "B-splines; leave out 'shape' and 'curve' of [strands]",
                    job.groom.name));
}

/// Binds the strands of a picture. Throws InputError where none is grown.
std::unique_ptr<PluginStrands> bind_strands(const PluginGroom& groom,
                                            const StrandRequest& request,
                                            const Job& job) {
    StageLine line;
    line.show("bind");
    auto out = std::make_unique<PluginStrands>(groom, request);
    line.clear();
    if (out->size() > 0) return out;
    const std::size_t all = groom.info().strands;
    if (request.strands_per_pixel > 0) {
        throw InputError(fmt::format("--lod: {} strands a pixel leave none of {} strands",
                                     request.strands_per_pixel, all));
    }
    throw InputError(fmt::format("{}: of {} strands a density of {} leaves none",
                                 job.groom.name, all, job.groom.density));
}

int preview(const PreviewOptions& options) {
    const std::size_t before = peak_rss();
    Job job = read_job(options.groom);
    const ChosenFrames chosen = chosen_frames(options.frames, job, false);
    const auto outputs = outputs_of(options, job, chosen);
    set_override(options, chosen, job.preview);
    std::optional<ViewRequest> request = view_request(options);
    const RenderSettings& settings = job.preview.render;
    StrandRequest asked;
    asked.faces = job.preview.hair.aspect < 1;
    if (asked.faces) check_faces(job);
    check_points(job.groom);

    std::unique_ptr<PluginGroom> groom = open_groom(job);
    const std::size_t views = options.turntable ? outputs.size() : 0;
    const std::vector<Camera> cameras = cameras_of(job, groom->box(), views);
    RenderScene scene;
    scene.hair = HairLook(job.preview.hair);
    scene.later_hair = later_hair(job.preview);
    scene.mesh = job.preview.mesh;
    scene.blade = job.preview.blade;
    std::optional<ContactSheet> sheet;
    if (!options.contact_sheet.empty()) {
        sheet = make_contact_sheet(outputs.size(), settings.width, settings.height,
                                   job.preview.background);
    }

    if (options.lod) {
        asked.pixels = chunk_pixels(*groom, cameras, settings.height);
        asked.strands_per_pixel = *options.lod;
    }

    nlohmann::json stats, frames = nlohmann::json::array();
    std::optional<CurveShape> shape = asked.faces ? CurveShape::flat : groom->shape();
    PictureCost total;
    std::vector<ShownTime> moments;
    std::vector<SceneTime> shown;
    std::optional<HairScene> geometry;
    std::optional<CheckView> view;
    Image image;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const double frame = chosen.frames[views ? 0 : i];
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
        if (views) {
            title = fmt::format("view {} of {}", i + 1, views);
        } else if (outputs.size() > 1) {
            title = fmt::format("frame {} ({} of {})", frame, i + 1, outputs.size());
        }
        PictureCost cost;
        // Views of a turntable share all but the camera; frames that are alike, all.
        const bool still =
            geometry && (views || as_before(moments, *groom, times.frames));
        if (!still) {
            geometry.reset();
            asked.times = times.frames;
            Stopwatch watch;
            auto strands = bind_strands(*groom, asked, job);
            cost.bind = watch.lap();
            if (stats.empty()) {
                print_binding_report(*strands);
                stats = groom_stats(*groom, *strands);
            }
            moments.clear();
            moments = grow(*groom, *strands, times.frames, job, cameras, shape, cost);
            // Strands keep the shape that the first picture gave them: nothing pops.
            shape = moments.front().curves.shape;
            if (request) {
                view = view_of(*request, *groom, *strands, moments[0], job.groom,
                               job.preview.hair.aspect);
                scene.view = &*view;
                fmt::print("{}\n", view_line(*request, *view));
                // The first picture's scale is that of all.
                keep_range(*view, *request);
            }
            // What only growing needs is let go before the BVH is built.
            strands.reset();
            if (views || i + 1 == outputs.size()) groom.reset();
            geometry.emplace(scene_of(moments, job, cost));
            scene.geometry = &*geometry;
            shown = scene_times(moments);
            scene.times = shown;
        }
        if (still && !views) {
            write_picture(outputs[i], image, job.preview.background);
        } else {
            const Camera& camera = cameras[views ? i : 0];
            scene.lights =
                job.preview.lights
                    ? *job.preview.lights
                    : default_lights(camera.view(), job.groom.scene.up.cast<float>());
            image = shoot(scene, camera, job.preview, options.progressive, title,
                          outputs[i], cost);
        }
        if (sheet) {
            add_picture(*sheet, i, image,
                        fmt::format("{}", views ? double(i + 1) : frame));
        }
        add_cost(cost, i == 0, total);
        frames.push_back({{"frame", frame_json(frame)},
                          {"image", outputs[i].picture.string()},
                          {"times", times.frames},
                          {"still", still},
                          {"seconds",
                           {{"bind", cost.bind},
                            {"expand", cost.expand},
                            {"bvh", cost.bvh},
                            {"render", cost.render}}}});
        print_picture(outputs[i].picture, stats, moments.front().curves.strands, cost);
        std::fflush(stdout);
    }
    if (sheet) write_image(options.contact_sheet, sheet->image);
    add_curve_stats(stats, moments[0].curves, total.expand);
    nlohmann::json& bind = stats["seconds"]["bind"];
    bind = bind.get<double>() + total.bind;
    stats["seconds"]["bvh"] = total.bvh;
    stats["seconds"]["render"] = total.render;
    stats["seconds"]["first_picture"] = total.first;
    stats["rays"] = total.rays;
    stats["paths"] = total.paths;
    add_memory_stats(stats, moments, total.bvh_bytes, before);
    stats["image"] = {{"width", settings.width},
                      {"height", settings.height},
                      {"samples", settings.samples}};
    if (view) stats["view"] = view_json(*request, *view);
    if (!chosen.cache.empty() || views) stats["frames"] = std::move(frames);
    write_stats(options.groom.stats, std::move(stats));
    return kFine;
}

}  // namespace

void add_preview(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<PreviewOptions>();
    CLI::App* command = app.add_subcommand("preview", "Render a picture of a groom");
    add_preview_options(*command, *options);
    command->callback([options, &exit_code] { exit_code = preview(*options); });
}

}  // namespace lancret
