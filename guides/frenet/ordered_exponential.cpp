#include "guides/frenet/ordered_exponential.h"

namespace lancret {

namespace {

/// The integral over one step of exp(Q s'), in rows: ds (I + c2 K + c3 K^2)^T, K =
/// hat(w).
Mat3 step_integral(const Vec3& u, double ds) {
    const Vec3 w = u * ds;
    const StepKernel<double> kernel = step_kernel(w.squaredNorm());
    const Mat3 k = hat<double>(w);
    return ds * (Mat3::Identity() + kernel.c2 * k + kernel.c3 * k * k).transpose();
}

}  // namespace

OrderedExponential ordered_exponential(const FrenetProfile& profile) {
    OrderedExponential out{{0.0}, {Mat3::Identity()}, {Mat3::Zero()}};
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Vec3 u = profile.rates[i].darboux();
        const double ds = profile.steps[i];
        Mat3 rotation = helix_step<double>(u, ds).rotation.transpose() * out.rotations[i];
        orthonormalize<double>(rotation);
        out.integrals.push_back(out.integrals[i] +
                                step_integral(u, ds) * out.rotations[i]);
        out.rotations.push_back(rotation);
        out.arc_lengths.push_back(out.arc_lengths[i] + ds);
    }
    return out;
}

std::vector<HelixState<double>> placed(const OrderedExponential& shape,
                                       const HelixState<double>& root) {
    std::vector<HelixState<double>> states;
    states.reserve(shape.rotations.size());
    for (std::size_t i = 0; i < shape.rotations.size(); ++i) {
        states.push_back(
            {root.frame * shape.rotations[i].transpose(),
             root.position + root.frame * shape.integrals[i].row(0).transpose()});
    }
    return states;
}

}  // namespace lancret
