#pragma once
// The quadrature points of a rod and their motion.

#include <vector>

#include "sim/rod/rod.h"
#include "sim/segment/quadrature.h"

namespace lancret {

/// The number of Gauss points per segment of a rod and their offsets in an array.
class PointLayout {
  public:
    /// Chooses the number of points per segment from its turn |k| l.
    void lay_out(std::span<const double> lengths, std::span<const Vec3> curvatures);

    int segments() const { return int(first_.size()) - 1; }
    int first(int segment) const { return first_[segment]; }
    int points(int segment) const { return first_[segment + 1] - first_[segment]; }
    int size() const { return first_.back(); }

  private:
    std::vector<int> first_{0};  ///< [segments + 1]
};

/// One vector per point: structure of arrays.
class PointVectors {
  public:
    /// Discards the values. Allocates only to grow.
    void resize(int points) {
        stride_ = std::size_t(points);
        if (values_.size() < 3 * stride_) values_.resize(3 * stride_);
    }
    std::size_t stride() const { return stride_; }
    double* at(int point) { return values_.data() + point; }
    const double* at(int point) const { return values_.data() + point; }
    double* axis(int c) { return values_.data() + c * stride_; }
    const double* axis(int c) const { return values_.data() + c * stride_; }
    PointTargets targets(int point) const {
        return {axis(0) + point, axis(1) + point, axis(2) + point};
    }
    Vec3 get(int i) const { return {axis(0)[i], axis(1)[i], axis(2)[i]}; }
    void set(int i, const Vec3& v) {
        for (int c = 0; c < 3; ++c) axis(c)[i] = v[c];
    }

  private:
    std::vector<double> values_;
    std::size_t stride_ = 0;
};

/// Positions of all points and of the joints from the end of the first segment to the
/// tip, cm, world axes. Resizes both.
void point_positions(std::span<const double> lengths, const HelixState<double>& root,
                     std::span<const Vec3> curvatures, const PointLayout& layout,
                     PointVectors& positions, std::vector<Vec3>& joints);

/// Velocities of all points and of the same joints, cm/s. Resizes both.
void point_velocities(const Rod& rod, const RodState& state, const PointLayout& layout,
                      PointVectors& velocities, std::vector<Vec3>& joints);

/// The points' accelerations without the term of q'', cm/s^2: those of the root's motion
/// and all terms quadratic in velocities [Bergbom07, Eq. 4.36, corrected], by one
/// recursion from the root. Resizes `bias`.
void point_bias(const Rod& rod, const RodState& state, const PointLayout& layout,
                PointVectors& bias);

}  // namespace lancret
