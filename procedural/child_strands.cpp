#include "procedural/child_strands.h"

#include <oneapi/tbb/parallel_for.h>

#include "procedural/buffer.h"

namespace lancret {

Strands child_strands(const Binding& binding, const GuideProfiles<float>& profiles,
                      const ExpandSettings& settings) {
    const std::size_t places = profiles.count + 1;
    Strands out;
    out.first.resize(binding.size() + 1);
    out.points.resize(binding.size() * places);
    out.thickness.resize(out.points.size());
    const auto [root, tip] = settings.taper;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, binding.size(), settings.chunk),
        [&](const auto& chunk) {
            std::vector<HelixState<float>> states(places);
            for (std::size_t i = chunk.begin(); i < chunk.end(); ++i) {
                synthesize_child<float>(binding, profiles, settings.blend, i, states);
                const float width = binding.roots.width(i);
                out.first[i + 1] = std::uint32_t((i + 1) * places);
                for (std::size_t j = 0; j < places; ++j) {
                    const float s = float(j) / float(profiles.count);
                    out.points[i * places + j] =
                        binding.roots.positions[i] + states[j].position;
                    out.thickness[i * places + j] = 2 * width * (root + (tip - root) * s);
                }
            }
        });
    return out;
}

}  // namespace lancret
