#include "tools/preview/picture.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "guides/base/stopwatch.h"
#include "render_test/image/denoise.h"
#include "render_test/image/exr.h"
#include "render_test/scene/strand_width.h"
#include "render_test/scene/thin_strands.h"
#include "render_test/trace/legend.h"
#include "tools/progress.h"

namespace lancret {

namespace {

/// Strands that are wide in any picture are round, all of them and at all times.
void choose_shape(std::span<const Camera> cameras, int height,
                  std::vector<ShownTime>& moments) {
    const auto wide = [&](const ShownTime& m) {
        return any_wider(m.curves, cameras, height, kFlatPixels);
    };
    if (!std::ranges::any_of(moments, wide)) return;
    for (ShownTime& m : moments) m.curves.shape = CurveShape::round;
}

}  // namespace

std::vector<SceneTime> scene_times(const std::vector<ShownTime>& moments) {
    std::vector<SceneTime> out;
    for (const ShownTime& m : moments) {
        out.push_back({&m.curves, m.body ? &*m.body : nullptr});
    }
    return out;
}

Channels channels_of(const PictureFiles& files, bool denoise) {
    const bool layers = files.picture.extension() == ".exr";
    return {.variance = layers || denoise,
            .motion = layers,
            .mattes = layers,
            .deep = !files.deep.empty()};
}

bool as_before(const std::vector<ShownTime>& moments, const PluginGroom& groom,
               const std::vector<double>& times) {
    if (moments.size() != times.size()) return false;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!groom.is_still(std::array{moments[i].frame, times[i]})) return false;
    }
    return true;
}

std::vector<ShownTime> grow(const PluginGroom& groom, const PluginStrands& strands,
                            const std::vector<double>& times, const Job& job,
                            std::span<const Camera> cameras,
                            const std::optional<CurveShape>& shape, PictureCost& cost) {
    StageLine line;
    line.show("expand");
    Stopwatch watch;
    std::vector<Curves> curves = strands.curves();
    cost.expand = watch.lap();
    line.clear();
    std::vector<ShownTime> out;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (shape) curves[i].shape = *shape;
        out.push_back({times[i], std::move(curves[i]), groom.head(times[i]), {}});
    }
    const int height = job.preview.render.height;
    if (!shape) choose_shape(cameras, height, out);
    for (ShownTime& m : out) {
        if (!(job.preview.least_width > 0)) break;
        m.true_radii =
            widen_thin_strands(m.curves, cameras, height, job.preview.least_width);
    }
    return out;
}

HairScene scene_of(const std::vector<ShownTime>& moments, const Job& job,
                   PictureCost& cost) {
    ProgressBar bar("BVH");
    HairScene out(scene_times(moments),
                  {.true_radii = moments.front().true_radii,
                   .crease = job.preview.crease,
                   .aspect = job.preview.hair.aspect,
                   .progress = [&](double done) { bar.show(done); }});
    cost.bvh = out.build_seconds();
    cost.bvh_bytes = out.bvh_bytes();
    return out;
}

void write_picture(const PictureFiles& files, const Image& image,
                   const Vec3f& background) {
    write_image(files.picture, image, background);
    if (!files.deep.empty()) write_deep_exr(files.deep, image);
}

Image shoot(const RenderScene& scene, const Camera& camera,
            const PreviewSettings& settings, bool progressive, const std::string& title,
            const PictureFiles& files, PictureCost& cost) {
    Stopwatch watch;
    cost.first = cost.render = 0;
    RenderSettings render_settings = settings.render;
    // A view's legend is drawn over its colours alone: mattes would not know of it.
    if (!scene.view) render_settings.channels = channels_of(files, settings.denoise);
    Image out;
    const auto write = [&](Image image) {
        if (settings.denoise) denoise(image);
        cost.render += watch.lap();
        if (cost.first == 0) cost.first = cost.render;
        out = std::move(image);
        if (scene.view) draw_legend(out, *scene.view);
        write_picture(files, out, settings.background);
        watch.lap();
    };
    ProgressBar bar(title);
    const auto progress = [&](const RenderProgress& p) {
        cost.rays = p.rays;
        cost.paths = p.paths;
        bar.show(p.done, p.rays);
    };
    if (progressive) {
        render_progressively(
            scene, camera, render_settings,
            [&](const Image& image, int) { write(image); }, progress);
    } else {
        write(render(scene, camera, render_settings, progress));
    }
    return out;
}

void add_memory_stats(nlohmann::json& stats, const std::vector<ShownTime>& moments,
                      std::size_t bvh, std::size_t process) {
    const Curves& curves = moments[0].curves;
    nlohmann::json& bytes = stats["bytes"];
    bytes["bvh"] = bvh;
    bytes["per_time"] = curves.bytes() - curves.segments.bytes();
    bytes["widths"] = moments[0].true_radii.size() * sizeof(float);
    for (const char* part : {"bvh", "per_time", "widths"}) {
        bytes[part + std::string("_per_strand")] =
            bytes[part].get<double>() / double(std::max(1u, curves.strands));
    }
    bytes["process"] = process;
}

Camera turned(const Camera& camera, const Vec3f& centre, const Vec3f& up, float angle) {
    const Mat3f turn = Eigen::AngleAxisf(angle, up.normalized()).toRotationMatrix();
    Camera out = camera;
    out.position = centre + turn * (camera.position - centre);
    out.frame = turn * camera.frame;
    return out;
}

}  // namespace lancret
