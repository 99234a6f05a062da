#include "procedural/child_strands.h"

#include "guides/cancel.h"
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
    const KernelGuides guides =
        kernel_guides(profiles, binding.guide_normals, settings.blend);
    const auto put = [&](std::size_t i, std::span<const HelixState<float>> states) {
        const float width = binding.roots.width(i);
        out.first[i + 1] = std::uint32_t((i + 1) * places);
        for (std::size_t j = 0; j < places; ++j) {
            const float s = float(j) / float(profiles.count);
            out.points[i * places + j] = binding.roots.positions[i] + states[j].position;
            out.thickness[i * places + j] = 2 * width * (root + (tip - root) * s);
        }
    };
    cancellable_for(tbb::blocked_range<std::size_t>(0, binding.size(), settings.chunk),
                    [&](const auto& chunk) {
                        each_strand(binding, profiles, guides, settings.blend,
                                    chunk.begin(), chunk.end(), put);
                    });
    return out;
}

}  // namespace lancret
