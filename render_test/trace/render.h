#pragma once
// A picture from a scene and a camera.

#include <cstdint>
#include <functional>

#include "render_test/image/image.h"
#include "render_test/scene/camera.h"
#include "render_test/trace/film.h"

namespace lancret {

/// Default sample limit for adaptive sampling.
inline constexpr int kMaxAdaptiveSamples = 1024;

struct RenderSettings {
    int width = 640, height = 640;  ///< pixels
    int samples = 64;               ///< paths per pixel, spread evenly over its square
    /// Relative noise at which sampling stops (adaptive.h); `samples` is then the maximum
    /// per pixel. 0: every pixel gets `samples`.
    float noise = 0;
    std::uint64_t seed = 0;
    PathSettings path;
    Channels channels;  ///< in addition to colour, depth, normal, tangent and id
};

struct RenderProgress {
    double done = 0;          ///< share, 0..1
    std::uint64_t rays = 0;   ///< traced so far, including shadow rays
    std::uint64_t paths = 0;  ///< followed so far: samples over all pixels
};
using ProgressFunction = std::function<void(const RenderProgress&)>;

/// Renders on all threads; the same bits for any number of them. `progress`, if given, is
/// called from any thread, one at a time. Throws std::invalid_argument if a setting is
/// out of range, std::runtime_error if a pixel is not a finite number.
Image render(const RenderScene& scene, const Camera& camera,
             const RenderSettings& settings, const ProgressFunction& progress = {});

/// Renders the same picture, bit for bit, and shows it in progress: `show` receives the
/// picture at 1, 2, 4, 8, ... samples per pixel and the final one. With a target noise
/// some pixels have fewer samples.
void render_progressively(const RenderScene& scene, const Camera& camera,
                          const RenderSettings& settings,
                          const std::function<void(const Image&, int samples)>& show,
                          const ProgressFunction& progress = {});

}  // namespace lancret
