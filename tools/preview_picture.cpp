#include "tools/preview_picture.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "render_test/denoise.h"
#include "render_test/image_exr.h"
#include "render_test/legend.h"
#include "render_test/strand_width.h"
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

bool same(const Guides& a, const Guides& b) {
    return a.segments == b.segments && a.root_positions == b.root_positions &&
           a.root_frames == b.root_frames && a.segment_lengths == b.segment_lengths &&
           a.curvatures == b.curvatures;
}

bool same(const ScalpPose& a, const ScalpPose& b) {
    if (a.index() != b.index()) return false;
    if (const auto* mesh = std::get_if<TriangleMesh>(&a)) {
        return mesh->positions == std::get<TriangleMesh>(b).positions;
    }
    const auto& x = std::get<RigidPose>(a);
    const auto& y = std::get<RigidPose>(b);
    return x.rotation == y.rotation && x.translation == y.translation;
}

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

bool as_before(const std::vector<ShownTime>& moments, const RestPlaces& rest,
               const ChosenFrames& chosen, const std::vector<double>& times,
               const Job& job) {
    if (moments.size() != times.size()) return false;
    for (std::size_t i = 0; i < times.size() && !chosen.cache.empty(); ++i) {
        const ScalpPose pose = job.pose_at ? job.pose_at(times[i]) : ScalpPose();
        if (!same(moments[i].state.pose, pose) ||
            !same(moments[i].state.guides,
                  guides_at(chosen, rest.guide_places, times[i]))) {
            return false;
        }
    }
    return true;
}

HairScene grow(Generator& generator, RestPlaces& rest, const ChosenFrames& chosen,
               const std::vector<double>& times, const Job& job,
               std::span<const Camera> cameras, std::vector<ShownTime>& moments,
               PictureCost& cost, bool last) {
    moments.clear();
    for (const double frame : times) {
        FrameState state = go_to_frame(generator, rest, chosen, frame);
        Stopwatch watch;
        Curves curves = expand(generator.binding, state.profiles, job.groom.expand);
        cost.expand += watch.lap();
        std::optional<TriangleMesh> body = body_of(generator.source, state.pose);
        moments.push_back({std::move(state), std::move(curves), std::move(body), {}});
    }
    if (!job.groom.expand.shape)
        choose_shape(cameras, job.preview.render.height, moments);
    for (ShownTime& m : moments) {
        if (!(job.preview.least_width > 0)) break;
        m.true_radii = widen_thin_strands(m.curves, cameras, job.preview.render.height,
                                          job.preview.least_width);
    }
    if (last) {
        generator.binding = generator.sample = {};
        rest = {};
    }
    HairScene geometry(scene_times(moments), {.true_radii = moments.front().true_radii,
                                              .crease = job.preview.crease,
                                              .aspect = job.preview.hair.aspect});
    cost.bvh = geometry.build_seconds();
    cost.bvh_bytes = geometry.bvh_bytes();
    return geometry;
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
