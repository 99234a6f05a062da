// Included once for each instruction set: no #pragma once.
// Transposes separate rows into adjacent columns, which is far cheaper than gathering.

#if defined(LANCRET_TRANSPOSE_ROWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LANCRET_TRANSPOSE_ROWS_INL
#undef LANCRET_TRANSPOSE_ROWS_INL
#else
#define LANCRET_TRANSPOSE_ROWS_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// to[j * step + lane] = rows[lane][j] for `lanes` rows (one, or a multiple of four) and
/// j below `count`, rounded up to a multiple of four; all aligned to 16 bytes.
HWY_INLINE void transpose_rows(const float* const* rows, std::size_t lanes,
                               std::size_t count, float* to, std::size_t step) {
#if HWY_TARGET == HWY_SCALAR
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        for (std::size_t j = 0; j < count; ++j) to[j * step + lane] = rows[lane][j];
    }
#else
    const hn::FixedTag<float, 4> four;
    const hn::FixedTag<double, 2> pairs;
    for (std::size_t lane = 0; lane < lanes; lane += 4) {
        const float* const* row = rows + lane;
        for (std::size_t j = 0; j < count; j += 4) {
            const auto a = hn::Load(four, row[0] + j), b = hn::Load(four, row[1] + j);
            const auto c = hn::Load(four, row[2] + j), d = hn::Load(four, row[3] + j);
            const auto ab = hn::BitCast(pairs, hn::InterleaveLower(four, a, b));
            const auto cd = hn::BitCast(pairs, hn::InterleaveLower(four, c, d));
            const auto ab2 = hn::BitCast(pairs, hn::InterleaveUpper(four, a, b));
            const auto cd2 = hn::BitCast(pairs, hn::InterleaveUpper(four, c, d));
            const auto store = [&](std::size_t k, auto v) {
                hn::Store(hn::BitCast(four, v), four, to + (j + k) * step + lane);
            };
            store(0, hn::InterleaveLower(pairs, ab, cd));
            store(1, hn::InterleaveUpper(pairs, ab, cd));
            store(2, hn::InterleaveLower(pairs, ab2, cd2));
            store(3, hn::InterleaveUpper(pairs, ab2, cd2));
        }
    }
#endif
}

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
