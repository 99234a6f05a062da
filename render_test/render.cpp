#include "render_test/render.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>

namespace lancret {
namespace {

constexpr int kTile = 16;

/// Gives the rays traced.
std::uint64_t render_pixel(const RenderScene& scene, const Camera& camera,
                           const RenderSettings& settings, int x, int y, Image& image) {
    const std::size_t pixel = std::size_t(y) * settings.width + x;
    const Vec2f size(float(settings.width), float(settings.height));
    Vec3f radiance = Vec3f::Zero(), normal = Vec3f::Zero(), tangent = Vec3f::Zero();
    float depth = 0;
    int hits = 0;
    std::uint64_t rays = 0;
    for (int s = 0; s < settings.samples; ++s) {
        Sampler sampler(settings.seed, std::uint32_t(pixel), std::uint32_t(s));
        const Vec2f place =
            (Vec2f(float(x), float(y)) + sampler.next()).cwiseQuotient(size);
        Ray ray = camera.ray(place);
        // One time a path; a pixel's times are spread evenly over the shutter.
        if (scene.geometry->moves()) ray.time = sampler.next().x();
        const PathResult path = trace_path(scene, settings.path, ray, sampler);
        radiance += path.radiance;
        rays += path.rays;
        if (path.first) {
            ++hits;
            depth += path.first->distance * ray.direction.dot(camera.view());
            normal += path.first->normal.dot(ray.direction) > 0
                          ? Vec3f(-path.first->normal)
                          : path.first->normal;
            if (path.first->kind == Hit::Kind::strand) tangent += path.first->tangent;
        }
        if (s > 0) continue;
        image.id[pixel] = !path.first                             ? kNothingId
                          : path.first->kind == Hit::Kind::strand ? path.first->strand
                                                                  : kMeshId;
    }
    const float share = 1 / float(settings.samples);
    const float alpha = settings.path.show_environment ? 1 : float(hits) * share;
    radiance *= share;
    if (!radiance.allFinite())
        throw std::runtime_error("pixel " + std::to_string(x) + ", " + std::to_string(y) +
                                 " is not a finite number: please report this");
    image.rgba[pixel] = {radiance.x(), radiance.y(), radiance.z(), alpha};
    if (hits == 0) return rays;
    image.depth[pixel] = depth / float(hits);
    image.normal[pixel] = normal / float(hits);
    image.tangent[pixel] = tangent / float(hits);
    return rays;
}

}  // namespace

Image render(const RenderScene& scene, const Camera& camera,
             const RenderSettings& settings,
             const std::function<void(const RenderProgress&)>& progress) {
    if (!scene.geometry) throw std::invalid_argument("a render needs geometry");
    if (settings.width < 1 || settings.height < 1 || settings.width > 32768 ||
        settings.height > 32768)
        throw std::invalid_argument(
            "a picture's sides must be within 1 and 32768 pixels");
    if (settings.samples < 1) throw std::invalid_argument("samples must be at least 1");
    if (settings.path.max_depth < 1)
        throw std::invalid_argument("max_depth must be at least 1");
    Image image(settings.width, settings.height);
    const int across = (settings.width + kTile - 1) / kTile;
    const int down = (settings.height + kTile - 1) / kTile;
    std::mutex mutex;
    int done = 0;
    std::uint64_t rays = 0;
    tbb::parallel_for(0, across * down, [&](int tile) {
        const int x0 = tile % across * kTile, y0 = tile / across * kTile;
        std::uint64_t traced = 0;
        for (int y = y0; y < std::min(y0 + kTile, settings.height); ++y)
            for (int x = x0; x < std::min(x0 + kTile, settings.width); ++x)
                traced += render_pixel(scene, camera, settings, x, y, image);
        if (!progress) return;
        const std::lock_guard lock(mutex);
        rays += traced;
        progress({double(++done) / (across * down), rays});
    });
    return image;
}

}  // namespace lancret
