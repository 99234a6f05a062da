// Included once for each instruction set: no #pragma once.
// Copies the control points of a strand from a small buffer to their destination.

#if defined(LANCRET_COPY_POINTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LANCRET_COPY_POINTS_INL
#undef LANCRET_COPY_POINTS_INL
#else
#define LANCRET_COPY_POINTS_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Copies `count` points, `stride` floats apart in `from`, to consecutive points at `to`;
/// both are aligned to 16 bytes. With `past_caches` the stores bypass the caches.
HWY_INLINE void copy_points(const float* from, std::size_t stride, std::size_t count,
                            Point4f* to, bool past_caches) {
#if HWY_TARGET == HWY_SCALAR
    (void)past_caches;
    for (std::size_t j = 0; j < count; ++j, from += stride) {
        to[j] = {from[0], from[1], from[2], from[3]};
    }
#else
    const hn::FixedTag<float, 4> four;
    float* out = &to->x;
    if (past_caches) {
        for (std::size_t j = 0; j < count; ++j) {
            hn::Stream(hn::Load(four, from + j * stride), four, out + 4 * j);
        }
    } else {
        for (std::size_t j = 0; j < count; ++j) {
            hn::Store(hn::Load(four, from + j * stride), four, out + 4 * j);
        }
    }
#endif
}

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
