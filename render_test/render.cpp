#include "render_test/render.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>

namespace lancret {
namespace {

constexpr int kTile = 16;

/// The pair of random dimensions for the lens, far from those of paths.
constexpr std::uint32_t kLensPair = 0x30000;

/// A picture on its way: sums over the samples so far in place of means.
struct Film {
    Image sums;                       ///< rgba's last is the coverage
    std::vector<std::uint32_t> hits;  ///< [pixels] samples that met something
    int samples = 0;
    std::uint64_t rays = 0;

    Film(int width, int height)
        : sums(width, height), hits(std::size_t(width) * height) {}
};

/// Samples `film.samples` up to `end` of one pixel. Gives the rays traced.
std::uint64_t sample_pixel(const RenderScene& scene, const Camera& camera,
                           const RenderSettings& settings, int x, int y, int end,
                           Film& film) {
    const std::size_t pixel = std::size_t(y) * settings.width + x;
    const Vec2f size(float(settings.width), float(settings.height));
    Image& sums = film.sums;
    PathSettings path_settings = settings.path;
    path_settings.pixel_angle = 2 * camera.tangent / size.y();
    std::uint64_t rays = 0;
    for (int s = film.samples; s < end; ++s) {
        Sampler sampler(settings.seed, std::uint32_t(pixel), std::uint32_t(s));
        const Vec2f place =
            (Vec2f(float(x), float(y)) + sampler.next()).cwiseQuotient(size);
        Ray ray = camera.ray(place);
        if (camera.lens_radius > 0) {
            Sampler lens(settings.seed, std::uint32_t(pixel), std::uint32_t(s));
            lens.skip_to(kLensPair);
            ray = camera.ray(place, lens.next());
        }
        // One time a path; a pixel's times are spread evenly over the shutter.
        if (scene.geometry->moves()) ray.time = sampler.next().x();
        const PathResult path = trace_path(scene, path_settings, ray, sampler);
        sums.rgba[pixel].head<3>() += path.radiance;
        sums.rgba[pixel].w() += path.coverage;
        rays += path.rays;
        if (path.first) {
            ++film.hits[pixel];
            sums.depth[pixel] += path.first->distance * ray.direction.dot(camera.view());
            sums.normal[pixel] += path.first->normal.dot(ray.direction) > 0
                                      ? Vec3f(-path.first->normal)
                                      : path.first->normal;
            if (path.first->kind == Hit::Kind::strand)
                sums.tangent[pixel] += path.first->tangent;
        }
        if (s > 0) continue;
        sums.id[pixel] = !path.first                             ? kNothingId
                         : path.first->kind == Hit::Kind::strand ? path.first->strand
                                                                 : kMeshId;
    }
    return rays;
}

/// Brings the film to `end` samples a pixel. `progress` hears of the share of all that is
/// then done.
void add_samples(const RenderScene& scene, const Camera& camera,
                 const RenderSettings& settings, int end, Film& film,
                 const ProgressFunction& progress) {
    const int across = (settings.width + kTile - 1) / kTile;
    const int down = (settings.height + kTile - 1) / kTile;
    std::mutex mutex;
    int done = 0;
    tbb::parallel_for(0, across * down, [&](int tile) {
        const int x0 = tile % across * kTile, y0 = tile / across * kTile;
        std::uint64_t rays = 0;
        for (int y = y0; y < std::min(y0 + kTile, settings.height); ++y)
            for (int x = x0; x < std::min(x0 + kTile, settings.width); ++x)
                rays += sample_pixel(scene, camera, settings, x, y, end, film);
        const std::lock_guard lock(mutex);
        film.rays += rays;
        const double samples =
            film.samples + (end - film.samples) * (double(++done) / (across * down));
        if (progress) progress({samples / settings.samples, film.rays});
    });
    film.samples = end;
}

/// The means, in place of the sums.
void finish(const RenderSettings& settings, const Film& film, Image& image) {
    const float share = 1 / float(film.samples);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        image.rgba[i] *= share;
        if (!image.rgba[i].allFinite())
            throw std::runtime_error("pixel " + std::to_string(i % settings.width) +
                                     ", " + std::to_string(i / settings.width) +
                                     " is not a finite number: please report this");
        if (settings.path.show_environment) image.rgba[i].w() = 1;
        if (film.hits[i] == 0) continue;
        const auto hits = float(film.hits[i]);
        image.depth[i] /= hits;
        image.normal[i] /= hits;
        image.tangent[i] /= hits;
    }
}

Film empty_film(const RenderScene& scene, const RenderSettings& settings) {
    if (!scene.geometry) throw std::invalid_argument("a render needs geometry");
    if (settings.width < 1 || settings.height < 1 || settings.width > 32768 ||
        settings.height > 32768)
        throw std::invalid_argument(
            "a picture's sides must be within 1 and 32768 pixels");
    if (settings.samples < 1) throw std::invalid_argument("samples must be at least 1");
    if (settings.path.max_depth < 1)
        throw std::invalid_argument("max_depth must be at least 1");
    return {settings.width, settings.height};
}

}  // namespace

Image render(const RenderScene& scene, const Camera& camera,
             const RenderSettings& settings, const ProgressFunction& progress) {
    Film film = empty_film(scene, settings);
    add_samples(scene, camera, settings, settings.samples, film, progress);
    finish(settings, film, film.sums);
    return std::move(film.sums);
}

void render_progressively(const RenderScene& scene, const Camera& camera,
                          const RenderSettings& settings,
                          const std::function<void(const Image&, int samples)>& show,
                          const ProgressFunction& progress) {
    Film film = empty_film(scene, settings);
    Image image(settings.width, settings.height);
    for (int end = 1; film.samples < settings.samples; end *= 2) {
        end = std::min(end, settings.samples);
        add_samples(scene, camera, settings, end, film, progress);
        image = film.sums;
        finish(settings, film, image);
        show(image, end);
    }
}

}  // namespace lancret
