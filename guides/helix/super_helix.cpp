#include "guides/helix/super_helix.h"

namespace lancret {

HelixState<double> state_at(const SuperHelix& helix, double s) {
    HelixState<double> out;
    sample(helix, std::span(&s, 1), [&](auto, auto, const auto& state) { out = state; });
    return out;
}

void positions_with_jacobian(const SuperHelix& helix, std::span<const double> s,
                             Eigen::VectorXd& positions, Eigen::MatrixXd& jacobian) {
    const std::size_t segments = helix.lengths.size();
    positions.resize(3 * s.size());
    jacobian.setZero(3 * s.size(), 3 * segments);

    // A change dk of a passed segment turns the rest of the strand by A dk and moves it
    // by B dk, as a rigid body turned about the origin: dr = A dk x r + B dk.
    std::vector<Mat3> turn(segments), shift(segments);
    HelixState<double> joint = helix.root;
    double start = 0;
    std::size_t passed = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        while (passed + 1 < segments && s[i] > start + helix.lengths[passed]) {
            const Vec3& u = helix.curvatures[passed];
            const HelixStepDerivative d = helix_step_derivative(u, helix.lengths[passed]);
            turn[passed] = joint.frame * d.angular;
            shift[passed] = joint.frame * d.position;
            advance<double>(joint, u, helix.lengths[passed]);
            for (int c = 0; c < 3; ++c) {
                shift[passed].col(c) -= turn[passed].col(c).cross(joint.position);
            }
            start += helix.lengths[passed++];
        }
        HelixState<double> state = joint;
        advance<double>(state, helix.curvatures[passed], s[i] - start);
        positions.segment<3>(3 * i) = state.position;
        for (std::size_t q = 0; q < passed; ++q) {
            for (int c = 0; c < 3; ++c) {
                jacobian.block<3, 1>(3 * i, 3 * q + c) =
                    turn[q].col(c).cross(state.position) + shift[q].col(c);
            }
        }
        jacobian.block<3, 3>(3 * i, 3 * passed) =
            joint.frame *
            helix_step_derivative(helix.curvatures[passed], s[i] - start).position;
    }
}

}  // namespace lancret
