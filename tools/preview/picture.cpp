#include "tools/preview/picture.h"

#include <algorithm>

#include "guides/base/stopwatch.h"
#include "render_test/files/deep_exr.h"
#include "render_test/files/write_image.h"
#include "render_test/image/denoise.h"
#include "render_test/trace/legend.h"
#include "tools/progress.h"

namespace lancret {

Channels channels_of(const PictureFiles& files, bool denoise) {
    const bool layers = files.picture.extension() == ".exr";
    return {.variance = layers || denoise,
            .motion = layers,
            .mattes = layers,
            .deep = !files.deep.empty()};
}

Image shoot(const PictureJob& job, PictureCost& cost) {
    const RenderScene& scene = job.scene;
    Stopwatch watch;
    cost.first = cost.render = 0;
    RenderSettings render_settings = job.settings.render;
    // The legend of a view is drawn over its colours only; mattes would not show it.
    if (!scene.view) {
        render_settings.channels = channels_of(job.files, job.settings.denoise);
    }
    Image out;
    const auto write = [&](Image image) {
        if (job.settings.denoise) denoise(image);
        cost.render += watch.lap();
        if (cost.first == 0) cost.first = cost.render;
        out = std::move(image);
        if (scene.view) draw_legend(out, *scene.view);
        write_picture(job.files, out, job.settings.background);
        watch.lap();
    };
    ProgressBar bar(job.title);
    const auto progress = [&](const RenderProgress& p) {
        cost.rays = p.rays;
        cost.paths = p.paths;
        bar.show(p.done, p.rays);
    };
    if (job.progressive) {
        render_progressively(
            scene, job.camera, render_settings,
            [&](const Image& image, int) { write(image); }, progress);
    } else {
        write(render(scene, job.camera, render_settings, progress));
    }
    return out;
}

void write_picture(const PictureFiles& files, const Image& image,
                   const Vec3f& background) {
    write_image(files.picture, image, background);
    if (!files.deep.empty()) write_deep_exr(files.deep, image);
}

void add_cost(const PictureCost& cost, bool is_first, PictureCost& total) {
    total.bind += cost.bind;
    total.expand += cost.expand;
    total.bvh += cost.bvh;
    total.render += cost.render;
    total.rays += cost.rays;
    total.paths += cost.paths;
    if (is_first) total.first = cost.first;
    total.bvh_bytes = std::max(total.bvh_bytes, cost.bvh_bytes);
}

}  // namespace lancret
