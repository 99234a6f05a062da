// Children along a path of roots: what is smooth over the scalp, and what is not.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "guides/point_tree.h"
#include "procedural/generator.h"

namespace lancret {
namespace {

/// The largest that neighbours on the path differ by, cm, each seen from its root: of a
/// place, and of the strand's spine as a whole (the chord and the two terms after it).
struct Jumps {
    double place = 0, spine = 0;
    int at = 0;  ///< the step of the largest difference of places
};

/// Steps along half a circle at the side of the made head, clear of its parting.
Jumps jumps_of(const Generator& groom, Blend blend, int steps) {
    Roots roots;
    for (int i = 0; i <= steps; ++i) {
        const double angle = 0.3 + 1.2 * i / steps;
        const Vec3 unit(0.8, 0.6 * std::sin(angle), -0.6 * std::cos(angle));
        const Vec3 normal = unit.cwiseQuotient(kMadeHead).normalized();
        roots.positions.push_back(unit.cwiseProduct(kMadeHead).cast<float>());
        roots.normals.push_back(normal.cast<float>());
    }
    const Binding binding = lancret::bind(std::move(roots), groom.source.guides,
                                          groom.source.normals, groom.groom.bind);
    const auto profiles = guide_profiles<double>(groom.source.guides, 96);
    std::vector<HelixState<double>> before(97), now(97);
    Spine<double> last;
    Jumps out;
    for (int i = 0; i <= steps; ++i) {
        synthesize_child<double>(binding, profiles, blend, i, now);
        const Spine<double> spine = spine_of<double>(
            profiles.basis, 1.0, [&](std::size_t j) { return now[j].position; });
        for (int j = 0; j <= 96 && i > 0; ++j) {
            const double moved = (now[j].position - before[j].position).norm();
            if (moved > out.place) out.at = i;
            out.place = std::max(out.place, moved);
        }
        for (int j = 0; j < 2 && i > 0; ++j) {
            out.spine = std::max(out.spine, (spine.terms[j] - last.terms[j]).norm());
        }
        before = now;
        last = spine;
    }
    return out;
}

TEST(RootPath, SumsAreSmoothAndDetailJumpsByItsCurlAlone) {
    Groom groom;
    groom.made.strands = 400;
    groom.guides.number = 150;
    groom.strands = 1;
    const Generator made = make_generator(groom);
    for (const BlendName& entry : kBlendNames) {
        SCOPED_TRACE(entry.name);
        const Jumps coarse = jumps_of(made, entry.blend, 2000),
                    fine = jumps_of(made, entry.blend, 4000);
        fmt::print("| {} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {} of 4000 |\n",
                   entry.name, coarse.place, fine.place, coarse.spine, fine.spine,
                   fine.at);
        const bool sums = entry.blend == Blend::position ||
                          entry.blend == Blend::option3 || entry.blend == Blend::option2;
        // Half the step, half the largest difference; weights are Lipschitz, not smooth,
        // so that the largest may fall between steps.
        if (sums) {
            EXPECT_LT(fine.place, 0.6 * coarse.place);
        }
        if (entry.blend == Blend::detail) {
            // Where another guide becomes the heaviest its curl takes over, of twice
            // its radius at most (0.35 cm, half as much again), about the same spine.
            EXPECT_LT(fine.place, 2 * 1.5 * 0.35);
            EXPECT_LT(fine.spine, 0.25 * jumps_of(made, Blend::nearest, 4000).spine);
        }
    }
}

}  // namespace
}  // namespace lancret
