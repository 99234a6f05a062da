#include "tools/evaluate/evaluate_picture.h"

#include <algorithm>

#include "render_test/image/draw.h"
#include "render_test/scene/embree_scene.h"

namespace lancret {

namespace {

/// Strands sampled at equal steps of s / L as cubic Hermite curves.
Curves curves_of(const StrandSamples& strands, std::span<const Vec3f> tangents,
                 const Taper& taper) {
    const std::uint32_t steps = std::uint32_t(strands.steps);
    Curves out;
    out.basis = CurveBasis::hermite;
    out.add_class(std::uint32_t(strands.size()), steps);
    out.points = Buffer<Point4f>(strands.points.size());
    out.tangents = Buffer<Point4f>(strands.points.size());
    out.segments = Buffer<std::uint32_t>(strands.size() * steps);
    const float thinner = (taper.tip - taper.root) / float(steps);
    for (std::uint32_t i = 0; i < out.strands; ++i) {
        for (std::uint32_t j = 0; j <= steps; ++j) {
            const std::uint32_t at = i * (steps + 1) + j;
            // Half the distance of its neighbours: some blends do not preserve arc
            // length.
            const std::uint32_t from = j == 0 ? at : at - 1,
                                to = j == steps ? at : at + 1;
            const double chord = (strands.points[to] - strands.points[from]).norm();
            const float ds = float(chord / (to - from));
            const Vec3f p = strands.points[at].cast<float>(), t = ds * tangents[at];
            out.points[at] = {p.x(), p.y(), p.z(), taper.root + thinner * float(j)};
            out.tangents[at] = {t.x(), t.y(), t.z(), thinner};
            if (j < steps) out.segments[i * steps + j] = at;
        }
    }
    return out;
}

/// The taper, thickened if strands at the middle of the box would be so thin that a
/// picture of few paths per pixel turns them into speckles.
Taper visible(const Taper& taper, const Camera& camera, const Vec3f& middle, int height) {
    constexpr float kMinRadius = 0.35f;  // pixels
    const float pixel =
        2 * camera.tangent * (middle - camera.position).norm() / float(height);
    const float min_radius = kMinRadius * pixel;
    if (!(taper.root > 0)) return {min_radius, std::max(min_radius, taper.tip)};
    const float thicker = std::max(1.0f, min_radius / taper.root);
    return {taper.root * thicker, taper.tip * thicker};
}

/// Copies `panel` into `strip` with its left side at `x`.
void copy_panel(const Image& panel, int x, Image& strip) {
    for (int y = 0; y < panel.height; ++y) {
        std::copy_n(panel.rgba.begin() + std::ptrdiff_t(y) * panel.width, panel.width,
                    strip.rgba.begin() + std::ptrdiff_t(y) * strip.width + x);
    }
}

Curves panel_curves(const StripStrands& strands, int panel, const Taper& taper) {
    const HoldOut& holdout = strands.holdout;
    if (panel == 0) return curves_of(holdout.truth, holdout.tangents, taper);
    const Prediction made =
        predict(holdout, strands.profiles, strands.blends[std::size_t(panel) - 1]);
    return curves_of(made.strands, made.tangents, taper);
}

}  // namespace

Image evaluation_strip(const StripStrands& strands, const StripView& view,
                       const std::function<void(double done)>& progress) {
    Eigen::AlignedBox3f box;
    for (const Vec3& p : strands.holdout.truth.points) box.extend(p.cast<float>());
    const Camera camera = preview_camera(view.preview, box, view.up);
    RenderScene scene;
    scene.hair = HairLook(view.preview.hair);
    scene.later_hair = later_hair(view.preview);
    scene.mesh = view.preview.mesh;
    scene.lights = view.preview.lights ? *view.preview.lights
                                       : default_lights(camera.view(), view.up);
    const RenderSettings& settings = view.preview.render;
    const Taper taper = visible(view.taper, camera, box.center(), settings.height);
    const int panels = 1 + int(strands.blends.size()),
              text_size = std::clamp(settings.height / 24, 8, 24);
    Image strip(panels * settings.width, settings.height);
    for (int panel = 0; panel < panels; ++panel) {
        const Curves curves = panel_curves(strands, panel, taper);
        const HairScene geometry(curves, view.body ? &*view.body : nullptr,
                                 {.crease = view.preview.crease});
        scene.geometry = &geometry;
        const auto panel_progress = [&](const RenderProgress& p) {
            progress((panel + p.done) / panels);
        };
        copy_panel(render(scene, camera, settings, panel_progress),
                   panel * settings.width, strip);
        scene.geometry = nullptr;
        const std::string name =
            panel == 0 ? "truth" : std::string(blend_name(strands.blends[panel - 1]));
        draw_text(strip, panel * settings.width + text_size, settings.height - text_size,
                  name, text_size, Vec3f::Constant(0.9f));
    }
    return strip;
}

}  // namespace lancret
