#include "guides/helix/helix.h"

namespace lancret {

KernelSlope kernel_slope(double x) {
    if (x < 1) {
        // Term by term: c2 = sum (-x)^n / (2n + 2)!, c3 = sum (-x)^n / (2n + 3)!.
        KernelSlope slope{0, 0};
        double power = -1, factorial2 = 24, factorial3 = 120;
        for (int n = 1; n <= 11; ++n) {
            slope.c2 += n * power / factorial2;
            slope.c3 += n * power / factorial3;
            power *= -x;
            factorial2 *= (2 * n + 3) * (2 * n + 4);
            factorial3 *= (2 * n + 4) * (2 * n + 5);
        }
        return slope;
    }
    const StepKernel<double> k = step_kernel(x);
    return {(k.c1 - 2 * k.c2) / (2 * x), (k.c2 - 3 * k.c3) / (2 * x)};
}

HelixStepDerivative helix_step_derivative(const Vec3& u, double ds) {
    // Apart from a factor ds of the displacement the step depends only on w = u ds:
    // p(w) = e0 + c2 hat(w) e0 + c3 hat(w)^2 e0, and d/du = ds d/dw.
    const Vec3 w = u * ds, e0 = Vec3::UnitX();
    const double x = w.squaredNorm();
    const StepKernel<double> kernel = step_kernel(x);
    const KernelSlope slope = kernel_slope(x);
    const Mat3 k = hat<double>(w);

    HelixStepDerivative out;
    out.angular = ds * (Mat3::Identity() + kernel.c2 * k + kernel.c3 * k * k);
    const Vec3 k_e0 = k * e0, kk_e0 = k * k_e0;
    for (int i = 0; i < 3; ++i) {
        const Vec3 e_i = Vec3::Unit(i), e_i_e0 = e_i.cross(e0);
        const double x_i = 2 * w[i];
        out.position.col(i) =
            ds * ds *
            (kernel.c2 * e_i_e0 + slope.c2 * x_i * k_e0 +
             kernel.c3 * (e_i.cross(k_e0) + k * e_i_e0) + slope.c3 * x_i * kk_e0);
    }
    return out;
}

}  // namespace lancret
