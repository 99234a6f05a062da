// Blend option2: the frames along the strand [TW99, Sec. 4.3, option 2]. The ordered
// exponentials U_k(s) of the guides, each applied to its root frame, are summed by
// weight, and the sum is projected to the nearest rotation. The frames are the material
// ones, as the Frenet frame is not defined on straight parts. Curls of different phase
// average out, and the strand straightens.

#include <Eigen/SVD>

#include "procedural/blend/blend.h"

namespace lancret {

namespace {

/// The rotation nearest to `sum` in the Frobenius norm; `before` if it is not unique.
template <class T>
Mat3T<T> nearest_rotation(const Mat3T<T>& sum, const Mat3T<T>& before) {
    const Eigen::JacobiSVD<Mat3T<T>> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    // One direction may vanish, but two must be determined.
    if (!(svd.singularValues()[1] > T(1e-5))) return before;
    Mat3T<T> u = svd.matrixU();
    if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
    return u * svd.matrixV().transpose();
}

}  // namespace

template <class T>
void blend_option2(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states) {
    const T ds = child.length / T(guides.count);
    for (int i = 0; i <= guides.count; ++i) {
        Mat3T<T> sum = Mat3T<T>::Zero();
        for (std::size_t k = 0; k < child.guides.size(); ++k) {
            sum +=
                child.weights[k] * child.to_space[k] * guides.frame(child.guides[k], i);
        }
        HelixState<T>& state = states[i];
        state.frame =
            nearest_rotation<T>(sum, i == 0 ? child.to_space[0] : states[i - 1].frame);
        orthonormalize<T>(state.frame);
        state.position = Vec3T<T>::Zero();
        if (i > 0) {
            const HelixState<T>& before = states[i - 1];
            state.position =
                before.position +
                before.frame * displacement_between<T>(before.frame, state.frame, ds);
        }
    }
}

template void blend_option2(const Child<float>&, const GuideProfiles<float>&,
                            std::span<HelixState<float>>);
template void blend_option2(const Child<double>&, const GuideProfiles<double>&,
                            std::span<HelixState<double>>);

}  // namespace lancret
