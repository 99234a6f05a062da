// Children along a path of roots: which blends are continuous over the scalp.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "procedural/groom/ready_groom.h"

namespace lancret {
namespace {

/// The largest difference of a place, relative to the root, between neighbours on the
/// path, cm.
struct Jumps {
    double place = 0;
    double same_curl = 0;  ///< between neighbours with the same heaviest guide
    int step = 0;          ///< of the largest difference
};

std::uint32_t heaviest(const Binding& binding, std::size_t i) {
    const auto first = binding.weights.begin() + std::ptrdiff_t(i * binding.neighbours);
    return binding.guides[std::max_element(first, first + binding.neighbours) -
                          binding.weights.begin()];
}

/// Along an arc on the side of the made head, clear of its parting.
Jumps jumps_of(const ReadyGroom& groom, Blend blend, int steps) {
    Roots roots;
    for (int i = 0; i <= steps; ++i) {
        const double angle = 0.3 + 1.2 * i / steps;
        const Vec3 unit(0.8, 0.6 * std::sin(angle), -0.6 * std::cos(angle));
        const Vec3 normal = unit.cwiseQuotient(kMadeHead).normalized();
        roots.positions.push_back(unit.cwiseProduct(kMadeHead).cast<float>());
        roots.normals.push_back(normal.cast<float>());
    }
    const Binding binding = lancret::bind(std::move(roots), groom.placed.guides,
                                          groom.placed.normals, groom.groom.bind);
    const auto profiles = guide_profiles<double>(groom.placed.guides, 96);
    std::vector<HelixState<double>> before(97), now(97);
    Jumps out;
    for (int i = 0; i <= steps; ++i) {
        synthesize_child<double>(binding, profiles, blend, i, now);
        for (int j = 0; j <= 96 && i > 0; ++j) {
            const double moved = (now[j].position - before[j].position).norm();
            if (moved > out.place) out.step = i;
            out.place = std::max(out.place, moved);
            if (heaviest(binding, i) == heaviest(binding, i - 1)) {
                out.same_curl = std::max(out.same_curl, moved);
            }
        }
        before = now;
    }
    return out;
}

TEST(RootPath, SumsAreContinuousAndDetailJumpsOnlyIfTheHeaviestGuideChanges) {
    GroomSettings groom;
    groom.made.strands = 400;
    groom.guides.number = 150;
    groom.strands = 1;
    const ReadyGroom made = make_ready_groom(groom);
    for (const BlendTraits& entry : blends()) {
        SCOPED_TRACE(entry.name);
        const Jumps coarse = jumps_of(made, entry.blend, 2000),
                    fine = jumps_of(made, entry.blend, 4000);
        fmt::print("| {} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {} of 4000 |\n",
                   entry.name, coarse.place, fine.place, coarse.same_curl, fine.same_curl,
                   fine.step);
        // Half the step gives half the largest difference; weights are Lipschitz, not
        // smooth, so that the maximum may fall between steps.
        if (entry.rates == BlendRates::none) {
            EXPECT_LT(fine.place, 0.6 * coarse.place);
        }
        if (entry.blend == Blend::detail) {
            // The curl jumps only if another guide becomes the heaviest.
            EXPECT_LT(fine.same_curl, 0.6 * coarse.same_curl);
            EXPECT_LT(fine.place, jumps_of(made, Blend::nearest, 4000).place);
        }
    }
}

}  // namespace
}  // namespace lancret
