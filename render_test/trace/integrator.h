#pragma once
// One sample of a picture: finds what the camera sees and shades it by light paths, by
// groom shading or by a check view.

#include <optional>

#include "render_test/sampling/sampler.h"
#include "render_test/trace/path_tracer.h"
#include "render_test/trace/render_scene.h"

namespace lancret {

struct PathResult {
    Vec3f radiance = Vec3f::Zero();
    std::optional<Hit> first;  ///< what the camera sees; behind thin strands, one of what
                               ///< it sees, chosen by share
    float coverage = 0;        ///< 0..1, less than one through thin strands
    std::uint32_t rays = 0;    ///< traced, including shadow rays
    float value = 0;           ///< figure of a check view at `first`
};

/// Traces one sample. Radiance is not clamped: a sample may be far brighter than its
/// pixel.
PathResult trace_path(const RenderScene& scene, const PathSettings& settings, Ray ray,
                      Sampler& sampler);

}  // namespace lancret
