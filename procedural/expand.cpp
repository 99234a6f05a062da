#include "procedural/expand.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <stdexcept>

namespace lancret {

template <class T>
void synthesize_child(const Binding& binding, const GuideProfiles<T>& profiles,
                      Blend blend, std::size_t i, std::span<HelixState<T>> states) {
    const BoundChild<T> bound = bound_child(binding, profiles, i);
    blend_function<T>(blend)(bound.child(), profiles, states);
}

template void synthesize_child(const Binding&, const GuideProfiles<float>&, Blend,
                               std::size_t, std::span<HelixState<float>>);
template void synthesize_child(const Binding&, const GuideProfiles<double>&, Blend,
                               std::size_t, std::span<HelixState<double>>);

Curves expand(const Binding& binding, const GuideProfiles<float>& profiles,
              const ExpandSettings& settings) {
    const std::size_t strands = binding.size(), n = profiles.count;
    Curves out;
    out.basis = settings.basis;
    out.shape = settings.shape;
    out.strands = std::uint32_t(strands);
    out.ids = binding.roots.ids;
    out.segments_per_strand = std::uint32_t(n);
    out.points_per_strand = control_points_of(settings.basis, out.segments_per_strand);
    if (strands * out.points_per_strand > std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument("expand: more control points than 32 bits can count");
    }
    out.points = Buffer<Point4f>(strands * out.points_per_strand);
    out.segments = Buffer<std::uint32_t>(strands * n);
    const bool hermite = settings.basis == CurveBasis::hermite;
    if (hermite) out.tangents = Buffer<Point4f>(out.points.size());

    const auto expand_chunk = [&](const tbb::blocked_range<std::size_t>& chunk) {
        std::vector<HelixState<float>> states(n + 1);
        for (std::size_t i = chunk.begin(); i < chunk.end(); ++i) {
            synthesize_child<float>(binding, profiles, settings.blend, i, states);
            const std::size_t first = i * out.points_per_strand;
            const auto points = out.points.span().subspan(first, out.points_per_strand);
            const float ds = binding.lengths[i] / float(n);
            const Vec3f& root = binding.roots.positions[i];
            const Taper taper = settings.taper.times(binding.roots.width(i));
            if (hermite) {
                hermite_points(states, ds, root, taper, points,
                               out.tangents.span().subspan(first, out.points_per_strand));
            } else {
                bspline_points(states, ds, root, taper, points);
            }
            for (std::size_t j = 0; j < n; ++j) {
                out.segments[i * n + j] = std::uint32_t(first + j);
            }
        }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, strands, settings.chunk),
                      expand_chunk, tbb::simple_partitioner());
    return out;
}

}  // namespace lancret
