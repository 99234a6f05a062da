#pragma once
// A groom's light from strand to strand, by two rays a sample: dual scattering [Zinke et
// al. 2008, "Dual Scattering Approximation for Fast Multiple Scattering in Hair"].
//
// Light on its way to a strand is scattered forward by each strand that it crosses: n
// strands leave T = 0.7 a_f^n of it, spread by n b_f^2 along the strand and over half a
// turn across it [Eq. 5-8]. At the strand, light goes on to its neighbours and comes
// back: A_b of it [Eq. 12-16]. Energies a_f and a_b, forward and backward of the viewer,
// are those of the far-field lobes. In place of the paper's, the lobe that comes back is
// (1 + cos phi) / (2 pi) across the strand, which has no edge, and its variance along it
// is the mean of the geometric series.

#include "render_test/far_lobes.h"
#include "render_test/path_tracer.h"

namespace lancret {

/// A strand among others, as light that has crossed some of them sees it; local axes and
/// meaning of values as HairBsdf's.
class DualHairBsdf {
  public:
    /// As FarHairBsdf.
    DualHairBsdf(const HairModel& model, const FarTable& table, const Vec3f& sigma_a,
                 const Vec3f& wo);

    /// Without what other strands add; `sample` and densities are its own.
    const FarHairBsdf& alone() const { return alone_; }
    /// For light that crosses this many strands on its way. Times cosine, 1/sr.
    Vec3f value(const Vec3f& wi, int crossed) const;
    /// Of light that crosses so many strands, what is left.
    Vec3f transmitted(int crossed) const;
    /// Of how many strands at least nearly nothing is left; 1 to 64.
    int most_crossed() const;

  private:
    FarHairBsdf alone_;
    const HairModel* model_;
    TurnedInclination wo_;
    Vec3f forward_, back_;     ///< a_f, A_b
    float forward_variance_;   ///< b_f^2
    Eigen::Array4f variance_;  ///< of the lobe that comes back, four times
};

/// What is seen at `hit` by light straight from lights, through strands: one ray to a
/// light and one where the strand scatters.
Vec3f dual_radiance(const RenderScene& scene, const Ray& ray, const Hit& hit,
                    Sampler& sampler, RayCounter& counter);

}  // namespace lancret
