#include "sim/equilibrium/sag_free.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "sim/rod/energy.h"
#include "sim/rod/system.h"

namespace lancret {

std::vector<Vec3> sag_free_natural(const HelixState<double>& root,
                                   std::span<const double> lengths,
                                   std::span<const Vec3> curvatures,
                                   const RodSection& section, const Vec3& gravity) {
    PointLayout layout;
    layout.lay_out(lengths, curvatures);
    PointVectors targets;
    std::vector<Vec3> joints, out(lengths.size());
    // Springs of strength rho S to targets displaced by g pull with the weight.
    point_positions(lengths, root, curvatures, layout, targets, joints);
    for (int i = 0; i < layout.size(); ++i) targets.set(i, targets.get(i) + gravity);
    RodSystem system;
    system.linearize(root, lengths, curvatures, layout, targets, section.linear_density);
    system.forces(out);
    for (std::size_t q = 0; q < out.size(); ++q) {
        out[q] = curvatures[q] - out[q].cwiseQuotient(lengths[q] * section.stiffness);
    }
    return out;
}

std::vector<Vec3> sag_free_natural(const Guides& guides, const RodSection& section,
                                   const Vec3& gravity) {
    std::vector<Vec3> out(guides.curvatures.size());
    tbb::parallel_for(std::size_t(0), guides.size(), [&](std::size_t g) {
        const auto one = sag_free_natural(guides.root(g), guides.lengths_of(g),
                                          guides.curvatures_of(g), section, gravity);
        std::ranges::copy(one, out.begin() + long(g) * guides.segments);
    });
    return out;
}

std::vector<std::size_t> falling_guides(const Guides& guides,
                                        std::span<const Vec3> natural,
                                        const RodSection& section, const Vec3& gravity) {
    const auto n = std::size_t(guides.segments);
    std::vector<char> falls(guides.size());
    tbb::parallel_for(std::size_t(0), guides.size(), [&](std::size_t g) {
        const auto lengths = guides.lengths_of(g);
        const auto natural_of_guide = natural.subspan(g * n, n);
        const HangingRod rod{guides.root(g),
                             {lengths.begin(), lengths.end()},
                             {natural_of_guide.begin(), natural_of_guide.end()},
                             section,
                             gravity};
        const auto q = Eigen::VectorXd::Map(guides.curvatures_of(g).front().data(),
                                            Eigen::Index(3 * n));
        const Eigen::LLT<Eigen::MatrixXd> factor(rod_hessian(rod, q));
        falls[g] = factor.info() != Eigen::Success;
    });
    std::vector<std::size_t> out;
    for (std::size_t g = 0; g < falls.size(); ++g) {
        if (falls[g]) out.push_back(g);
    }
    return out;
}

}  // namespace lancret
