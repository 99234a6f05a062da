#pragma once
// How a strand scatters light at one offset h across it [Chiang et al. 2016, "A Practical
// and Controllable Hair and Fur Model for Production Path Tracing"].
//
// Lobes: R (off the surface), TT (through), TRT (reflected once inside), and the residual
// of all longer paths. Each is a longitudinal M, an azimuthal N and an attenuation A.
//
// Local axes of a direction: x the tangent from root to tip, z across the tangent and
// nearest to the viewer, y = z cross x. So the viewer `wo` has y = 0, and h is positive
// towards +y. Values are f(wo, wi) times the cosine of wi's inclination to the plane
// across the strand, the whole factor of a path tracer. They integrate to one over the
// sphere of wi if nothing is absorbed.

#include <array>
#include <optional>

#include "guides/base/types.h"
#include "render_test/material/bsdf.h"
#include "render_test/material/hair_colour.h"

namespace lancret {

inline constexpr int kHairLobes = 4;

/// The part of a material that is the same at every hit. Arrays hold one number per lobe.
struct HairModel {
    explicit HairModel(const HairMaterial& material);  ///< throws std::invalid_argument

    Eigen::Array4f variance;      ///< v of M
    Eigen::Array4f spread;        ///< 1 - exp(-2 / v)
    Eigen::Array4f sine, cosine;  ///< of the turn of wo's inclination by the scales' tilt
    Vec3f sigma_a;                ///< per radius
    float eta;
    float s;       ///< scale of the logistic N
    float s_tail;  ///< its distribution function at -pi, untrimmed
};

struct StrandSection;

/// wo's inclination per lobe, turned by the scales' tilt.
struct TurnedInclination {
    Eigen::Array4f sine, cosine;
};

/// The lobes at one hit.
class HairBsdf {
  public:
    /// `wo` is unit, in local axes (y = 0); h in [-1, 1]. The model must outlive it.
    HairBsdf(const HairModel& model, const Vec3f& wo, float h)
        : HairBsdf(model, model.sigma_a, wo, h) {}
    /// With another absorption (per radius) than the model's.
    HairBsdf(const HairModel& model, const Vec3f& sigma_a, const Vec3f& wo, float h);
    /// With an elliptic section (strand_section.h): the same lobes, about the paths that
    /// a ray takes through the ellipse. For a circle, the same bits as without a section.
    HairBsdf(const HairModel& model, const Vec3f& sigma_a, const Vec3f& wo, float h,
             const StrandSection& section);

    BsdfValue evaluate(const Vec3f& wi) const;
    /// `pick` chooses the lobe; all in [0, 1). nullopt if the density underflows.
    std::optional<BsdfSample> sample(float pick, float azimuth,
                                     const Vec2f& longitude) const;

  private:
    friend struct LobeInspection;  // tests of single lobes

    /// M N of each lobe.
    Eigen::Array4f densities(float sine_i, float cosine_i, float phi_i) const;
    BsdfValue evaluate(float sine_i, float cosine_i, float phi_i) const;

    const HairModel* model_;
    std::array<Vec3f, kHairLobes> attenuation_;  ///< A
    Eigen::Array4f probability_;                 ///< of sampling each lobe
    TurnedInclination wo_;
    Eigen::Array4f phi_;  ///< azimuth of the specular path; unused by the residual
};

}  // namespace lancret
