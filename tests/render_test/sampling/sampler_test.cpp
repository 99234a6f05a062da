#include "render_test/sampling/sampler.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

TEST(Sampler, EverySixteenSamplesFillEveryElementaryInterval) {
    // A (0, 2)-sequence has one of its 16 points in each box of area 1/16, for every
    // shape of box; Owen scrambling and shuffles of whole runs preserve that.
    for (const std::uint32_t pixel : {0u, 7u, 123456u}) {
        for (int pair = 0; pair < 5; ++pair) {
            std::set<int> boxes[5];
            for (std::uint32_t s = 0; s < 16; ++s) {
                Sampler sampler(3, pixel, s);
                sampler.skip_to(std::uint32_t(pair));
                const Vec2f p = sampler.next();
                for (int k = 0; k <= 4; ++k) {
                    boxes[k].insert(int(p.x() * float(1 << k)) * 16 +
                                    int(p.y() * float(16 >> k)));
                }
            }
            for (const auto& box : boxes) EXPECT_EQ(box.size(), 16u);
        }
    }
}

TEST(Sampler, PairsAndPixelsAreIndependent) {
    // The correlation of n = 4096 pairs of uniform numbers has a deviation of 1 /
    // sqrt(n).
    Mean product_of_pairs, product_of_pixels;
    for (std::uint32_t i = 0; i < 4096; ++i) {
        Sampler a(1, i, 0), b(1, i + 1, 0);
        const Vec2f first = a.next() - Vec2f::Constant(0.5f);
        const Vec2f second = a.next() - Vec2f::Constant(0.5f);
        const Vec2f other = b.next() - Vec2f::Constant(0.5f);
        product_of_pairs.add(12 * first.x() * second.x());
        product_of_pixels.add(12 * first.y() * other.y());
    }
    EXPECT_LT(std::abs(product_of_pairs.value()), kSigmas / 64);
    EXPECT_LT(std::abs(product_of_pixels.value()), kSigmas / 64);
}

TEST(Sampler, SeedChangesTheNumbers) {
    EXPECT_NE(Sampler(1, 5, 5).next(), Sampler(2, 5, 5).next());
    EXPECT_EQ(Sampler(1, 5, 5).next(), Sampler(1, 5, 5).next());
}

}  // namespace
}  // namespace lancret
