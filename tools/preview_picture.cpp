#include "tools/preview_picture.h"

#include "render_test/thin_strands.h"
#include "tools/progress.h"
#include "tools/stats.h"

namespace lancret {

namespace {

/// What is seen of the head at that time.
std::optional<TriangleMesh> body_of(const GroomGuides& source, const ScalpPose& pose) {
    if (source.body) return posed_mesh(*source.body, pose);
    if (source.scalp) return posed_mesh(source.scalp->mesh, pose);
    return std::nullopt;
}

}  // namespace

HairScene grow(Generator& generator, const RestPlaces& rest, const ChosenFrames& chosen,
               const std::vector<double>& times, const Job& job,
               std::span<const Camera> cameras, std::vector<ShownTime>& moments,
               PictureCost& cost) {
    moments.clear();
    for (const double frame : times) {
        const FrameState state = go_to_frame(generator, rest, chosen, job, frame);
        Stopwatch watch;
        moments.push_back(
            {expand(generator.binding, state.profiles, job.groom.expand), {}, {}});
        cost.expand += watch.lap();
        moments.back().body = body_of(generator.source, state.pose);
        if (job.preview.least_width > 0) {
            moments.back().true_radii =
                widen_thin_strands(moments.back().curves, cameras,
                                   job.preview.render.height, job.preview.least_width);
        }
    }
    std::vector<SceneTime> scene_times;
    for (const ShownTime& m : moments) {
        scene_times.push_back({&m.curves, m.body ? &*m.body : nullptr});
    }
    HairScene geometry(scene_times, {.true_radii = moments.front().true_radii,
                                     .crease = job.preview.crease,
                                     .aspect = job.preview.hair.aspect});
    cost.bvh = geometry.build_seconds();
    cost.bvh_bytes = geometry.bvh_bytes();
    return geometry;
}

void shoot(const RenderScene& scene, const Camera& camera,
           const PreviewSettings& settings, bool progressive, const std::string& title,
           const std::filesystem::path& output, PictureCost& cost) {
    Stopwatch watch;
    cost.first = cost.render = 0;
    const auto write = [&](const Image& image) {
        cost.render += watch.lap();
        if (cost.first == 0) cost.first = cost.render;
        write_image(output, image, settings.background);
        watch.lap();
    };
    ProgressBar bar(title);
    const auto progress = [&](const RenderProgress& p) {
        cost.rays = p.rays;
        bar.show(p.done, p.rays);
    };
    if (progressive) {
        render_progressively(
            scene, camera, settings.render,
            [&](const Image& image, int) { write(image); }, progress);
    } else {
        write(render(scene, camera, settings.render, progress));
    }
}

Camera turned(const Camera& camera, const Vec3f& centre, const Vec3f& up, float angle) {
    const Mat3f turn = Eigen::AngleAxisf(angle, up.normalized()).toRotationMatrix();
    Camera out = camera;
    out.position = centre + turn * (camera.position - centre);
    out.frame = turn * camera.frame;
    return out;
}

}  // namespace lancret
