#include "render_test/trace/render.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "render_test/scene/motion.h"
#include "render_test/trace/adaptive.h"

namespace lancret {
namespace {

constexpr int kTile = 16;

/// The pair of random dimensions for the lens, far from those of paths.
constexpr std::uint32_t kLensPair = 0x30000;

/// Of the first pass towards a noise: enough, with its neighbours', to tell a pixel's.
constexpr int kFirstPass = 4;

/// Brings one pixel to `end` samples. Gives the rays traced. `deep` is room for deep
/// samples, empty before and after.
std::uint64_t sample_pixel(const RenderScene& scene, const Camera& camera,
                           const RenderSettings& settings, int x, int y, int end,
                           Film& film, std::vector<DeepSample>& deep) {
    const std::size_t pixel = std::size_t(y) * settings.width + x;
    const Vec2f size(float(settings.width), float(settings.height));
    PathSettings path_settings = settings.path;
    path_settings.pixel_angle = 2 * camera.tangent / size.y();
    std::uint64_t rays = 0;
    for (int s = int(film.samples[pixel]); s < end; ++s) {
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
        Sighting sighting{.path = path, .direction = ray.direction};
        if (path.first) {
            sighting.depth = path.first->distance * ray.direction.dot(camera.view());
            if (settings.channels.motion)
                sighting.motion =
                    screen_motion(scene.times, camera, settings.height, *path.first);
        }
        add_sample(film, pixel, sighting);
        if (settings.channels.deep) gather_deep(sighting, deep);
        rays += path.rays;
    }
    if (settings.channels.deep) add_deep(film, pixel, deep);
    return rays;
}

/// Brings every pixel to `end` samples, or to what it needs where `needed` has [pixels]
/// and that is less. `progress` hears of the share of all work, which goes from the first
/// to the second of `share`.
void add_samples(const RenderScene& scene, const Camera& camera,
                 const RenderSettings& settings, int end,
                 const std::vector<std::uint32_t>& needed, Vec2 share, Film& film,
                 const ProgressFunction& progress) {
    const int across = (settings.width + kTile - 1) / kTile;
    const int down = (settings.height + kTile - 1) / kTile;
    std::mutex mutex;
    int done = 0;
    tbb::parallel_for(0, across * down, [&](int tile) {
        const int x0 = tile % across * kTile, y0 = tile / across * kTile;
        std::uint64_t rays = 0, paths = 0;
        std::vector<DeepSample> deep;
        for (int y = y0; y < std::min(y0 + kTile, settings.height); ++y)
            for (int x = x0; x < std::min(x0 + kTile, settings.width); ++x) {
                const std::size_t pixel = std::size_t(y) * settings.width + x;
                const std::uint32_t before = film.samples[pixel];
                const int own = needed.empty() ? end : std::min(end, int(needed[pixel]));
                if (own <= int(before)) continue;
                paths += std::uint64_t(own) - before;
                rays += sample_pixel(scene, camera, settings, x, y, own, film, deep);
            }
        const std::lock_guard lock(mutex);
        film.rays += rays;
        film.paths += paths;
        const double part = double(++done) / (across * down);
        if (progress)
            progress({share.x() + part * (share.y() - share.x()), film.rays, film.paths});
    });
}

/// The means of all pixels, in place of the sums.
void finish(const RenderSettings& settings, const Film& film, Image& image) {
    if (settings.channels.variance) image.variance.resize(image.rgba.size());
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        finish_pixel(film, i, image);
        if (settings.path.show_environment) image.rgba[i].w() = 1;
    }
}

Film empty_film(const RenderScene& scene, const Camera& camera,
                const RenderSettings& settings) {
    if (!scene.geometry) throw std::invalid_argument("a render needs geometry");
    if (settings.width < 1 || settings.height < 1 || settings.width > 32768 ||
        settings.height > 32768)
        throw std::invalid_argument(
            "a picture's sides must be within 1 and 32768 pixels");
    if (!(settings.noise >= 0) || !std::isfinite(settings.noise))
        throw std::invalid_argument("noise must be 0 or more");
    if (settings.samples < 1) throw std::invalid_argument("samples must be at least 1");
    if (settings.path.max_depth < 1)
        throw std::invalid_argument("max_depth must be at least 1");
    if (settings.channels.deep && settings.path.show_environment)
        throw std::invalid_argument("deep pictures have no environment behind them");
    Channels channels = settings.channels;
    channels.variance |= settings.noise > 0;
    channels.value |= scene.view != nullptr;
    Film film(settings.width, settings.height, channels);
    // Neighbouring hits of a strand that runs into the picture at up to 60 degrees are
    // two pixels apart in depth.
    film.deep_gap = 4 * camera.tangent / float(settings.height);
    return film;
}

/// The share of the work that is done when those who need more have `end` samples.
double share_at(const Film& film, const std::vector<std::uint32_t>& needed, int end) {
    double done = 0, all = 0;
    for (std::size_t i = 0; i < needed.size(); ++i) {
        const std::uint32_t own = std::max(needed[i], film.samples[i]);
        done += std::min(double(own), std::max(double(end), double(film.samples[i])));
        all += own;
    }
    return done / all;
}

/// Renders in passes: one of `first` samples a pixel, and others that bring those who
/// need more to twice as many at most. After each, `show` gets the samples that a pixel
/// has at most by then.
template <class Show>
void render_in_passes(const RenderScene& scene, const Camera& camera,
                      const RenderSettings& settings, int first, Film& film,
                      const ProgressFunction& progress, const Show& show) {
    std::vector<std::uint32_t> needed;
    double from = 0;
    for (int end = first;; end *= 2) {
        end = std::min(end, settings.samples);
        const double to = needed.empty() ? double(end) / settings.samples
                                         : std::max(from, share_at(film, needed, end));
        add_samples(scene, camera, settings, end, needed, {from, to}, film, progress);
        from = to;
        if (settings.noise > 0 && end >= kFirstPass)
            needed =
                samples_needed(film, settings.noise, std::uint32_t(settings.samples));
        const bool enough = !needed.empty() &&
                            std::ranges::equal(needed, film.samples, std::less_equal<>());
        show(end);
        if (enough || end == settings.samples) break;
    }
    if (progress && from < 1) progress({1, film.rays, film.paths});
}

}  // namespace

Image render(const RenderScene& scene, const Camera& camera,
             const RenderSettings& settings, const ProgressFunction& progress) {
    Film film = empty_film(scene, camera, settings);
    render_in_passes(scene, camera, settings,
                     settings.noise > 0 ? kFirstPass : settings.samples, film, progress,
                     [](int) {});
    finish(settings, film, film.sums);
    return std::move(film.sums);
}

void render_progressively(const RenderScene& scene, const Camera& camera,
                          const RenderSettings& settings,
                          const std::function<void(const Image&, int samples)>& show,
                          const ProgressFunction& progress) {
    Film film = empty_film(scene, camera, settings);
    Image image(settings.width, settings.height);
    render_in_passes(scene, camera, settings, 1, film, progress, [&](int samples) {
        image = film.sums;
        finish(settings, film, image);
        show(image, samples);
    });
}

}  // namespace lancret
