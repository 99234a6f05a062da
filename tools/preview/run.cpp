#include "tools/preview/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "guides/base/errors.h"
#include "guides/base/stopwatch.h"
#include "render_test/files/write_image.h"
#include "render_test/image/contact_sheet.h"
#include "tools/preview/check_views.h"
#include "tools/preview/groom.h"
#include "tools/preview/lod.h"
#include "tools/preview/plan.h"
#include "tools/preview/run_stats.h"
#include "tools/preview/shown_times.h"
#include "tools/preview/view_summary.h"
#include "tools/progress.h"
#include "tools/stats.h"

namespace lancret {

namespace {

/// The camera rotated about the axis `up` through `centre` by `angle`, radian.
Camera turned(const Camera& camera, const Vec3f& centre, const Vec3f& up, float angle) {
    const Mat3f turn = Eigen::AngleAxisf(angle, up.normalized()).toRotationMatrix();
    Camera out = camera;
    out.position = centre + turn * (camera.position - centre);
    out.frame = turn * camera.frame;
    return out;
}

/// One camera for all pictures, or one per view of a turntable. It frames the rest pose
/// and stays there for every frame.
std::vector<Camera> cameras_of(const PreviewPlan& plan, const Eigen::AlignedBox3f& box) {
    const Vec3f up = plan.job.groom.scene.up.cast<float>();
    const Camera front = preview_camera(plan.job.preview, box, up);
    std::vector<Camera> out(std::max<std::size_t>(plan.views, 1), front);
    for (std::size_t view = 0; view < plan.views; ++view) {
        const float step = 2 * kPif / float(plan.views);
        out[view] = turned(front, box.center(), up, float(view) * step);
    }
    return out;
}

/// Binds the strands of a picture. Throws InputError if none is grown.
std::unique_ptr<PluginStrands> bind_strands(const PluginGroom& groom,
                                            const StrandRequest& request,
                                            const GroomSettings& settings) {
    StageLine line;
    line.show("bind");
    auto out = std::make_unique<PluginStrands>(groom, request);
    line.clear();
    if (out->size() > 0) return out;
    const std::size_t all = groom.info().strands;
    if (request.strands_per_pixel > 0) {
        throw InputError(
            fmt::format("--lod: {} strands per pixel leave none of the {} "
                        "strands",
                        request.strands_per_pixel, all));
    }
    throw InputError(fmt::format("{}: density {} leaves none of the {} strands",
                                 settings.name, settings.density, all));
}

HairScene scene_of(const std::vector<ShownTime>& moments, const PreviewSettings& settings,
                   PictureCost& cost) {
    ProgressBar bar("BVH");
    HairScene out(scene_times(moments),
                  {.true_radii = moments.front().true_radii,
                   .crease = settings.crease,
                   .aspect = settings.hair.aspect,
                   .progress = [&](double done) { bar.show(done); }});
    cost.bvh = out.build_seconds();
    cost.bvh_bytes = out.bvh_bytes();
    return out;
}

void warn_of_cut(const ChosenFrames& chosen, double frame, const ShutterTimes& shutter) {
    fmt::print(
        stderr,
        "lancret: warning: frame {}: the cache has frames {} to {}, and the shutter "
        "is cut to {} to {}\n",
        frame, chosen.first(), chosen.last(), shutter.frames.front(),
        shutter.frames.back());
}

/// Owns what is kept from picture to picture: views of a turntable share all but the
/// camera, and frames at which nothing moves share the picture itself.
class PreviewRun {
  public:
    /// Opens the groom. `options` must outlive the run. Throws InputError.
    explicit PreviewRun(const PreviewOptions& options);

    /// Renders and writes all pictures and the contact sheet. Throws InputError.
    void shoot_all();
    /// Statistics of all pictures, for --stats.
    nlohmann::json stats() const;

  private:
    void shoot_one(std::size_t i);
    std::string title_of(std::size_t i) const;
    /// Grows the strands of picture `i` and builds their scene.
    void grow_scene(std::size_t i, const std::vector<double>& times, PictureCost& cost);
    void set_view(const PluginStrands& strands);
    void build_geometry(PictureCost& cost);

    const PreviewOptions& options_;
    const std::size_t initial_bytes_;  ///< of the process, before the groom was read
    PreviewPlan plan_;
    std::unique_ptr<PluginGroom> groom_;  ///< until the last strands are grown
    std::vector<Camera> cameras_;         ///< one, or one per view
    std::optional<ContactSheet> sheet_;
    StrandRequest strand_request_;
    std::optional<CurveShape> shape_;  ///< of strands, as in the first picture
    std::vector<ShownTime> moments_;   ///< of the current picture
    std::vector<SceneTime> times_;     ///< of `moments_`
    std::optional<HairScene> geometry_;
    std::optional<CheckView> view_;
    RenderScene scene_;
    Image image_;  ///< the last one
    PictureCost total_;
    nlohmann::json groom_stats_, frames_ = nlohmann::json::array();
};

PreviewRun::PreviewRun(const PreviewOptions& options)
    : options_(options), initial_bytes_(peak_rss()), plan_(plan_of(options)) {
    groom_ = open_groom(plan_.job);
    cameras_ = cameras_of(plan_, groom_->box());
    const PreviewSettings& settings = plan_.job.preview;
    scene_.hair = HairLook(settings.hair);
    scene_.later_hair = later_hair(settings);
    scene_.mesh = settings.mesh;
    scene_.blade = settings.blade;
    if (!options.contact_sheet.empty()) {
        sheet_ = make_contact_sheet(plan_.outputs.size(), settings.render.width,
                                    settings.render.height, settings.background);
    }
    strand_request_.faces = plan_.elliptic;
    if (options.lod) {
        strand_request_.pixels = chunk_pixels(*groom_, cameras_, settings.render.height);
        strand_request_.strands_per_pixel = *options.lod;
    }
    shape_ = plan_.elliptic ? CurveShape::flat : groom_->shape();
}

void PreviewRun::shoot_all() {
    for (std::size_t i = 0; i < plan_.outputs.size(); ++i) shoot_one(i);
    if (sheet_) write_image(options_.contact_sheet, sheet_->image);
}

void PreviewRun::shoot_one(std::size_t i) {
    const PreviewSettings& settings = plan_.job.preview;
    const double frame = plan_.frame(i);
    const ShutterTimes shutter =
        shutter_times(plan_.chosen, frame, settings.shutter, settings.motion_samples);
    if (shutter.cut) warn_of_cut(plan_.chosen, frame, shutter);
    const std::vector<double>& times = shutter.frames;
    PictureCost cost;
    const bool still =
        geometry_ && (plan_.views || is_unchanged(moments_, *groom_, times));
    if (!still) grow_scene(i, times, cost);
    if (still && !plan_.views) {
        write_picture(plan_.outputs[i], image_, settings.background);
    } else {
        const Camera& camera = cameras_[plan_.views ? i : 0];
        scene_.lights =
            settings.lights
                ? *settings.lights
                : default_lights(camera.view(), plan_.job.groom.scene.up.cast<float>());
        image_ = shoot({scene_, camera, settings, plan_.outputs[i], title_of(i),
                        options_.progressive},
                       cost);
    }
    if (sheet_) {
        add_picture(*sheet_, i, image_,
                    fmt::format("{}", plan_.views ? double(i + 1) : frame));
    }
    add_cost(cost, i == 0, total_);
    frames_.push_back(picture_json(frame, times, still, plan_.outputs[i], cost));
    print_picture(plan_.outputs[i].picture, groom_stats_, moments_.front().curves.strands,
                  cost);
    std::fflush(stdout);
}

std::string PreviewRun::title_of(std::size_t i) const {
    const std::size_t count = plan_.outputs.size();
    if (plan_.views) return fmt::format("view {} of {}", i + 1, count);
    if (count == 1) return "render";
    return fmt::format("frame {} ({} of {})", plan_.frame(i), i + 1, count);
}

void PreviewRun::grow_scene(std::size_t i, const std::vector<double>& times,
                            PictureCost& cost) {
    const PreviewSettings& settings = plan_.job.preview;
    geometry_.reset();
    strand_request_.times = times;
    Stopwatch watch;
    auto strands = bind_strands(*groom_, strand_request_, plan_.job.groom);
    cost.bind = watch.lap();
    if (groom_stats_.empty()) {
        print_binding_report(*strands);
        groom_stats_ = groom_stats(*groom_, *strands);
    }
    moments_.clear();
    moments_ = grow(*groom_, *strands, times,
                    {cameras_, settings.render.height, settings.min_width, shape_}, cost);
    // Strands keep the shape of the first picture, so that nothing pops.
    shape_ = moments_.front().curves.shape;
    if (plan_.view) set_view(*strands);
    // Free what only growing needs before the BVH is built.
    strands.reset();
    if (plan_.views || i + 1 == plan_.outputs.size()) groom_.reset();
    build_geometry(cost);
}

void PreviewRun::set_view(const PluginStrands& strands) {
    ViewRequest& request = *plan_.view;
    view_ = view_of(request, {*groom_, strands, moments_[0], plan_.job.groom,
                              plan_.job.preview.hair.aspect});
    scene_.view = &*view_;
    fmt::print("{}\n", view_line(request, *view_));
    // All pictures use the scale of the first.
    keep_range(*view_, request);
}

void PreviewRun::build_geometry(PictureCost& cost) {
    geometry_.emplace(scene_of(moments_, plan_.job.preview, cost));
    scene_.geometry = &*geometry_;
    times_ = scene_times(moments_);
    scene_.times = times_;
}

nlohmann::json PreviewRun::stats() const {
    const RenderSettings& settings = plan_.job.preview.render;
    nlohmann::json out = groom_stats_;
    add_curve_stats(out, moments_[0].curves, total_.expand);
    add_cost_stats(out, total_);
    add_memory_stats(out, moments_[0], total_.bvh_bytes, initial_bytes_);
    out["image"] = {{"width", settings.width},
                    {"height", settings.height},
                    {"samples", settings.samples}};
    if (view_) out["view"] = view_json(*plan_.view, *view_);
    if (!plan_.chosen.cache.empty() || plan_.views) out["frames"] = frames_;
    return out;
}

}  // namespace

nlohmann::json run_preview(const PreviewOptions& options) {
    PreviewRun run(options);
    run.shoot_all();
    return run.stats();
}

}  // namespace lancret
