#pragma once
// Expansion: child i = f(guides, binding, i), the same bits for any chunk size, thread
// count or order.

#include <span>

#include "procedural/binding.h"
#include "procedural/control_points.h"
#include "procedural/curves.h"
#include "procedural/kernels/kernel_guides.h"

namespace lancret {

struct ExpandSettings {
    Blend blend = Blend::detail;
    CurveBasis basis = CurveBasis::bspline;
    CurveShape shape = CurveShape::flat;
    Taper taper{};
    std::uint32_t chunk = 256;  ///< strands that one task expands at a time, >= 1
    bool kernels = true;        ///< vectors where a kernel has the blend; false: scalar
                                ///< blends alone, to compare with
};

/// All children as control points. The guides' profiles say at how many intervals.
Curves expand(const Binding& binding, const GuideProfiles<float>& profiles,
              const ExpandSettings& settings);

/// The same into `out`, whose memory is used again where its sizes fit: the next frame.
void expand(const Binding& binding, const GuideProfiles<float>& profiles,
            const ExpandSettings& settings, Curves& out);

/// Child i by the scalar blends, before its control points are made: profiles.count + 1
/// places at equal steps of arc length, positions from its root in cm. What the kernels
/// are compared with.
template <class T>
void synthesize_child(const Binding& binding, const GuideProfiles<T>& profiles,
                      Blend blend, std::size_t i, std::span<HelixState<T>> states);

/// Children as `expand` synthesises them, to look at: by the kernel where there is one
/// with frames, else by the scalar blends. The arguments of its making must outlive it.
struct Synthesis {
    const Binding& binding;
    const GuideProfiles<float>& profiles;
    Blend blend;
    KernelGuides guides;  ///< none where the scalar blends serve

    Synthesis(const Binding& binding, const GuideProfiles<float>& profiles, Blend blend);
};

/// Children [first, first + count): profiles.count + 1 places of each in `states`.
void synthesize(const Synthesis& synthesis, std::size_t first, std::size_t count,
                std::span<HelixState<float>> states);

}  // namespace lancret
