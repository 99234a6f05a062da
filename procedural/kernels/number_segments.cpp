// The index buffer of the curves: the first control point of each segment.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/number_segments.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "procedural/kernels/strand_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void NumberSegments(std::size_t first, std::size_t count, std::uint32_t points,
                    std::uint32_t intervals, std::uint32_t* segments, bool past_caches) {
    const hn::CappedTag<std::uint32_t, 16> d;
    const std::size_t lanes = hn::Lanes(d), size = count * intervals;
    const auto number = [&](std::size_t i) {
        return std::uint32_t(first + i / intervals * points + i % intervals);
    };
    std::size_t i = 0;
    while (i < size && reinterpret_cast<std::uintptr_t>(segments + i) % 64 != 0) {
        segments[i] = number(i);
        ++i;
    }
    // A lane past a strand's end belongs to the next strand. It skips the difference of
    // points and segments once for each strand that it passes.
    std::uint32_t in_strand = std::uint32_t(i % intervals);
    std::uint32_t base = std::uint32_t(first + i / intervals * points);
    const auto steps = hn::Iota(d, 0), skip = hn::Set(d, points - intervals);
    for (; i + lanes <= size; i += lanes) {
        auto numbers = hn::Add(hn::Set(d, base + in_strand), steps);
        const auto places = hn::Add(hn::Set(d, in_strand), steps);
        std::uint32_t end = intervals;
        for (; end < in_strand + lanes; end += intervals) {
            numbers =
                hn::Add(numbers, hn::IfThenElseZero(places > hn::Set(d, end - 1), skip));
        }
        if (past_caches) {
            hn::Stream(numbers, d, segments + i);
        } else {
            hn::Store(numbers, d, segments + i);
        }
        in_strand += std::uint32_t(lanes);
        while (in_strand >= intervals) {
            in_strand -= intervals;
            base += points;
        }
    }
    for (; i < size; ++i) segments[i] = number(i);
    if (past_caches) hwy::FlushStream();
}

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lancret {

HWY_EXPORT(NumberSegments);

void number_segments(std::size_t first, std::size_t count, std::uint32_t points,
                     std::uint32_t intervals, std::uint32_t* segments, bool past_caches) {
    HWY_DYNAMIC_DISPATCH(NumberSegments)
    (first, count, points, intervals, segments, past_caches);
}

}  // namespace lancret
#endif
