#pragma once
// The shapes of children, frames and places, before control points are made from them.

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "procedural/bind/child.h"
#include "procedural/kernels/kernel_guides.h"

namespace lancret {

/// Children and the guides that shape them.
struct SynthesisInput {
    const Binding& binding;
    const GuideProfiles<float>& profiles;
    const KernelGuides& guides;  ///< of `profiles`; if empty, no kernel is used
    Blend blend;
};

/// Synthesises children [first, first + count) exactly as `expand` does: with the curl
/// kernel if the blend has it, otherwise with the scalar blend. Writes profiles.count + 1
/// places per child to `states`.
void synthesize(const SynthesisInput& in, std::size_t first, std::size_t count,
                std::span<HelixState<float>> states);

/// The code that `synthesize` runs for a blend, given kernel guides: "kernel " and the
/// instruction set, such as "kernel AVX2", or "scalar".
std::string synthesis_code(Blend blend);

/// Calls visit(i, states of child i) for the children [first, last), which are
/// synthesised in batches.
template <class Visit>
void each_strand(const SynthesisInput& in, std::size_t first, std::size_t last,
                 const Visit& visit) {
    constexpr std::size_t kTogether = 64;
    const std::size_t places = std::size_t(in.profiles.count) + 1;
    std::vector<HelixState<float>> batch(std::min(kTogether, last - first) * places);
    for (std::size_t i = first; i < last; i += kTogether) {
        const std::size_t count = std::min(kTogether, last - i);
        synthesize(in, i, count, batch);
        for (std::size_t s = 0; s < count; ++s) {
            visit(i + s,
                  std::span<const HelixState<float>>(batch).subspan(s * places, places));
        }
    }
}

}  // namespace lancret
