// The kernel of blend position, vectorised over the control points of a strand. Places,
// the parabolas beyond their ends and the five taps are all linear in the guides' places,
// so a child's control points are the weighted sum of its guides'.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/position_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/aligned_allocator.h>
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>

#include "procedural/bind/child.h"
#include "procedural/kernels/position_kernel.h"
// after the headers it uses
#include "procedural/kernels/copy_points.inl"

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// sum(factors[k] * rows[k]), the vector of it that begins at `first`.
template <class D>
HWY_INLINE hn::Vec<D> weighted_sum(D d, const float* const* rows, const float* factors,
                                   std::size_t count, std::size_t first) {
    auto sum = hn::Mul(hn::Set(d, factors[0]), hn::Load(d, rows[0] + first));
    for (std::size_t k = 1; k < count; ++k) {
        sum = hn::MulAdd(hn::Set(d, factors[k]), hn::Load(d, rows[k] + first), sum);
    }
    return sum;
}

void Positions(const KernelInput& in, const KernelOutput& out) {
    const hn::CappedTag<float, 16> d;
    const std::size_t lanes = hn::Lanes(d);
    const KernelGuides& guides = in.guides;
    const std::size_t points = guides.count + 3, stride = guides.point_stride;
    const auto radii = hwy::AllocateAligned<float>(stride);
    const auto strand = hwy::AllocateAligned<float>(4 * stride);
    for (std::size_t j = 0; j < stride; ++j) {
        radii[j] = radius_of(in.taper, std::ptrdiff_t(j) - 1, guides.count);
    }
    for (std::size_t s = 0; s < out.count; ++s) {
        const std::size_t i = out.first + s;
        LightChild child = light_child(in.binding, i);
        float length = 0;
        const float* rows[kMaxNeighbours];
        for (std::size_t k = 0; k < child.count; ++k) {
            length += child.weights[k] * in.profiles.lengths[child.guides[k]];
            rows[k] = &guides.points[child.guides[k] * 3 * stride];
        }
        // The groom may scale children to be longer or shorter than their guides.
        const float scale = in.binding.lengths[i] / length;
        for (std::size_t k = 0; k < child.count; ++k) child.weights[k] *= scale;
        const Vec3f& root = in.binding.roots.positions[i];
        const auto width = hn::Set(d, in.binding.roots.width(i));
        for (std::size_t j = 0; j < points; j += lanes) {
            const auto along = [&](int axis) {
                return hn::Add(hn::Set(d, root[axis]),
                               weighted_sum(d, rows, child.weights, child.count,
                                            std::size_t(axis) * stride + j));
            };
            hn::StoreInterleaved4(along(0), along(1), along(2),
                                  hn::Mul(width, hn::Load(d, &radii[j])), d,
                                  &strand[4 * j]);
        }
        copy_points(strand.get(), 4, points, out.points + s * points, out.past_caches);
    }
    if (out.past_caches) hwy::FlushStream();
}

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lancret {

HWY_EXPORT(Positions);

void expand_positions(const KernelInput& in, const KernelOutput& out) {
    HWY_DYNAMIC_DISPATCH(Positions)(in, out);
}

}  // namespace lancret
#endif
