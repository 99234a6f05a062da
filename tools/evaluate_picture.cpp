#include "tools/evaluate_picture.h"

#include <algorithm>

#include "render_test/scene/embree_scene.h"

namespace lancret {

namespace {

/// Strands at equal steps of s / L as cubic Hermite curves.
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
            // Half the way between its neighbours: the arc of some blends runs unevenly.
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

/// The taper, thickened where strands would be so thin at the middle of the box that a
/// picture of few paths a pixel shows sparkles in their stead.
Taper visible(const Taper& taper, const Camera& camera, const Vec3f& middle, int height) {
    constexpr float kMinRadius = 0.35f;  // pixels
    const float pixel =
        2 * camera.tangent * (middle - camera.position).norm() / float(height);
    const float least = kMinRadius * pixel;
    if (!(taper.root > 0)) return {least, std::max(least, taper.tip)};
    const float thicker = std::max(1.0f, least / taper.root);
    return {taper.root * thicker, taper.tip * thicker};
}

/// `panel` put into `strip` with its left side at `x`.
void put(const Image& panel, int x, Image& strip) {
    for (int y = 0; y < panel.height; ++y) {
        std::copy_n(panel.rgba.begin() + std::ptrdiff_t(y) * panel.width, panel.width,
                    strip.rgba.begin() + std::ptrdiff_t(y) * strip.width + x);
    }
}

}  // namespace

Image evaluation_strip(const HoldOut& taken, const GuideProfiles<float>& profiles,
                       const std::vector<Blend>& blends, const StripView& view,
                       const std::function<void(double done)>& progress) {
    Eigen::AlignedBox3f box;
    for (const Vec3& p : taken.truth.points) box.extend(p.cast<float>());
    const Camera camera = preview_camera(view.preview, box, view.up);
    RenderScene scene;
    scene.hair = HairLook(view.preview.hair);
    scene.later_hair = later_hair(view.preview);
    scene.mesh = view.preview.mesh;
    scene.lights = view.preview.lights ? *view.preview.lights
                                       : default_lights(camera.view(), view.up);
    const RenderSettings& settings = view.preview.render;
    const Taper taper = visible(view.taper, camera, box.center(), settings.height);
    const int panels = 1 + int(blends.size()),
              size = std::clamp(settings.height / 24, 8, 24);
    Image strip(panels * settings.width, settings.height);
    for (int panel = 0; panel < panels; ++panel) {
        Curves curves;
        if (panel == 0) {
            curves = curves_of(taken.truth, taken.tangents, taper);
        } else {
            const Prediction made = predict(taken, profiles, blends[panel - 1]);
            curves = curves_of(made.strands, made.tangents, taper);
        }
        const HairScene geometry(curves, view.body ? &*view.body : nullptr,
                                 {.crease = view.preview.crease});
        scene.geometry = &geometry;
        put(render(scene, camera, settings,
                   [&](const RenderProgress& p) { progress((panel + p.done) / panels); }),
            panel * settings.width, strip);
        scene.geometry = nullptr;
        const std::string name =
            panel == 0 ? "truth" : std::string(blend_name(blends[panel - 1]));
        draw_text(strip, panel * settings.width + size, settings.height - size, name,
                  size, Vec3f::Constant(0.9f));
    }
    return strip;
}

}  // namespace lancret
