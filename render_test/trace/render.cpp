#include "render_test/trace/render.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "render_test/scene/motion.h"
#include "render_test/trace/adaptive.h"
#include "render_test/trace/sample_pairs.h"

namespace lancret {
namespace {

constexpr int kTile = 16;

/// Samples of the first pass towards a noise: with those of the neighbours, enough to
/// estimate a pixel's variance.
constexpr int kFirstPass = 4;

/// A picture to render.
struct RenderJob {
    const RenderScene& scene;
    const Camera& camera;
    const RenderSettings& settings;
};

/// A pixel, and the number of samples to bring it to.
struct PixelTarget {
    int x, y;
    int end;
};

/// Brings one pixel to its target. Returns the number of rays traced. `deep` is scratch
/// space, empty before and after.
std::uint64_t sample_pixel(const RenderJob& job, const PixelTarget& target, Film& film,
                           std::vector<DeepSample>& deep) {
    const RenderSettings& settings = job.settings;
    const Camera& camera = job.camera;
    const std::size_t pixel = std::size_t(target.y) * settings.width + target.x;
    const Vec2f size(float(settings.width), float(settings.height));
    PathSettings path_settings = settings.path;
    path_settings.pixel_angle = 2 * camera.tangent / size.y();
    std::uint64_t rays = 0;
    for (int s = int(film.samples[pixel]); s < target.end; ++s) {
        Sampler sampler(settings.seed, std::uint32_t(pixel), std::uint32_t(s));
        const Vec2f place = (Vec2f(float(target.x), float(target.y)) + sampler.next())
                                .cwiseQuotient(size);
        Ray ray = camera.ray(place);
        if (camera.lens_radius > 0) {
            Sampler lens(settings.seed, std::uint32_t(pixel), std::uint32_t(s));
            lens.skip_to(kLensPair);
            ray = camera.ray(place, lens.next());
        }
        // One time per path; those of a pixel are spread evenly over the shutter.
        if (job.scene.geometry->moves()) ray.time = sampler.next().x();
        const PathResult path = trace_path(job.scene, path_settings, ray, sampler);
        Sighting sighting{.path = path, .direction = ray.direction};
        if (path.first) {
            sighting.depth = path.first->distance * ray.direction.dot(camera.view());
            if (settings.channels.motion) {
                sighting.motion =
                    screen_motion(job.scene.times, camera, settings.height, *path.first);
            }
        }
        add_sample(film, pixel, sighting);
        if (settings.channels.deep) gather_deep(sighting, deep);
        rays += path.rays;
    }
    if (settings.channels.deep) add_deep(film, pixel, deep);
    return rays;
}

/// One pass over all pixels.
struct Pass {
    int end;  ///< samples to bring every pixel to, unless it needs fewer
    const std::vector<std::uint32_t>& needed;  ///< [pixels], or empty: `end`
    Vec2 progress;                             ///< share of all work before and after
};

void add_samples(const RenderJob& job, const Pass& pass, Film& film,
                 const ProgressFunction& progress) {
    const RenderSettings& settings = job.settings;
    const int across = (settings.width + kTile - 1) / kTile;
    const int down = (settings.height + kTile - 1) / kTile;
    std::mutex mutex;
    int done = 0;
    const auto end_of = [&](std::size_t pixel) {
        return pass.needed.empty() ? pass.end
                                   : std::min(pass.end, int(pass.needed[pixel]));
    };
    tbb::parallel_for(0, across * down, [&](int tile) {
        const int x0 = tile % across * kTile, y0 = tile / across * kTile;
        std::uint64_t rays = 0, paths = 0;
        std::vector<DeepSample> deep;
        for (int y = y0; y < std::min(y0 + kTile, settings.height); ++y) {
            for (int x = x0; x < std::min(x0 + kTile, settings.width); ++x) {
                const std::size_t pixel = std::size_t(y) * settings.width + x;
                const std::uint32_t before = film.samples[pixel];
                const int end = end_of(pixel);
                if (end <= int(before)) continue;
                paths += std::uint64_t(end) - before;
                rays += sample_pixel(job, {x, y, end}, film, deep);
            }
        }
        const std::lock_guard lock(mutex);
        film.rays += rays;
        film.paths += paths;
        const double part = double(++done) / (across * down);
        const double from = pass.progress.x(), to = pass.progress.y();
        if (progress) progress({from + part * (to - from), film.rays, film.paths});
    });
}

/// Replaces the sums of all pixels by means.
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
        settings.height > 32768) {
        throw std::invalid_argument("the sides of a picture must be 1 to 32768 pixels");
    }
    if (!(settings.noise >= 0) || !std::isfinite(settings.noise)) {
        throw std::invalid_argument("noise must be 0 or more");
    }
    if (settings.samples < 1) throw std::invalid_argument("samples must be at least 1");
    if (settings.path.max_depth < 1) {
        throw std::invalid_argument("max_depth must be at least 1");
    }
    if (settings.channels.deep && settings.path.show_environment) {
        throw std::invalid_argument("deep images cannot show the environment");
    }
    Channels channels = settings.channels;
    channels.variance |= settings.noise > 0;
    channels.value |= scene.view != nullptr;
    Film film(settings.width, settings.height, channels);
    // Neighbouring hits on a strand inclined by up to 60 degrees differ in depth by up to
    // two pixels.
    film.deep_gap = 4 * camera.tangent / float(settings.height);
    return film;
}

/// Share of all work that is done when pixels that need more have `end` samples.
double share_at(const Film& film, const std::vector<std::uint32_t>& needed, int end) {
    double done = 0, all = 0;
    for (std::size_t i = 0; i < needed.size(); ++i) {
        const std::uint32_t total = std::max(needed[i], film.samples[i]);
        done += std::min(double(total), std::max(double(end), double(film.samples[i])));
        all += total;
    }
    return done / all;
}

/// Renders in passes: one of `first` samples per pixel, then others that at most double
/// the samples of pixels that need more. After each pass, calls `show` with the maximum
/// number of samples per pixel so far.
template <class Show>
void render_in_passes(const RenderJob& job, int first, Film& film,
                      const ProgressFunction& progress, const Show& show) {
    const RenderSettings& settings = job.settings;
    std::vector<std::uint32_t> needed;
    double from = 0;
    for (int end = first;; end *= 2) {
        end = std::min(end, settings.samples);
        const double to = needed.empty() ? double(end) / settings.samples
                                         : std::max(from, share_at(film, needed, end));
        add_samples(job, {end, needed, {from, to}}, film, progress);
        from = to;
        if (settings.noise > 0 && end >= kFirstPass) {
            needed =
                samples_needed(film, settings.noise, std::uint32_t(settings.samples));
        }
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
    render_in_passes({scene, camera, settings},
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
    render_in_passes({scene, camera, settings}, 1, film, progress, [&](int samples) {
        image = film.sums;
        finish(settings, film, image);
        show(image, samples);
    });
}

}  // namespace lancret
