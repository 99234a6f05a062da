#include <gtest/gtest.h>
#include <cstdio>
#include "procedural/check_strand.h"
#include "procedural/kernels/strand_kernels.h"
#include "tests/procedural/every_target.h"
#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::MadeHair;
using test::on_every_target;

TEST(CurlKernel, Probe) {
    for (const Blend blend : {Blend::nearest, Blend::detail})
    for (const int n : {14, 40}) {
    const MadeHair hair(1000, n, 3);
    const auto fine = guide_profiles<double>(hair.standing.guides, n);
    const KernelGuides guides = kernel_guides(hair.profiles, hair.standing.normals);
    std::vector<HelixState<double>> exact(n + 1);
    std::vector<HelixState<float>> scalar(n + 1), fast(1000 * (n + 1));
    on_every_target([&] {
        const KernelInput in{hair.binding, hair.profiles, guides, blend, CurveBasis::bspline, {}};
        ASSERT_TRUE(synthesize_strands(in, 0, 1000, fast));
        double a = 0, b = 0, fa = 0, fb = 0, o = 0;
        for (std::size_t i = 0; i < 1000; ++i) {
            synthesize_child<double>(hair.binding, fine, blend, i, exact);
            synthesize_child<float>(hair.binding, hair.profiles, blend, i, scalar);
            const auto own = std::span(fast).subspan(i * (n + 1), n + 1);
            o = std::max(o, orthogonality_error(own));
            for (int j = 0; j <= n; ++j) {
                a = std::max(a, (own[j].position.cast<double>() - exact[j].position).norm());
                b = std::max(b, (scalar[j].position.cast<double>() - exact[j].position).norm());
                fa = std::max(fa, (own[j].frame.cast<double>() - exact[j].frame).norm());
                fb = std::max(fb, (scalar[j].frame.cast<double>() - exact[j].frame).norm());
            }
        }
        std::printf("%d n %d kernel %g scalar %g frames %g %g orth %g\n", int(blend), n, a, b, fa, fb, o);
        const Curves x = expand(hair.binding, hair.profiles, {.blend = blend});
        const Curves y = expand(hair.binding, hair.profiles, {.blend = blend, .kernels = false});
        double c = 0;
        for (std::size_t i = 0; i < x.points.size(); ++i) c = std::max<double>(c, (x.points[i].xyz() - y.points[i].xyz()).norm());
        std::printf("   points %g\n", c);
    });
    }
}

}  // namespace
}  // namespace lancret
