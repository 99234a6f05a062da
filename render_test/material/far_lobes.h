#pragma once
// How a strand too thin to be resolved scatters light: HairBsdf's lobes averaged over the
// offset h, attenuation inside the average [d'Eon et al. 2011, "An Energy-Conserving Hair
// Reflectance Model", Eq. 10]:
//
//     N_p(phi) = 1/2 integral over h in [-1, 1] of A_p(h) D(phi - Phi_p(h))
//
// A ribbon is met with h even across it, so this is the exact mean of what near-field
// lobes show, without the noise of h.
//
// One table serves any absorption. On its way a ray crosses the strand p times, each of
// length 2 c / cos(theta_t) radii with c = cos(gamma_t) in [sqrt(1 - 1 / eta^2), 1]. So
// A_p holds exp(-p a c) with a = 2 sigma_a / cos(theta_t), which is interpolated in c by
// Lagrange's cubic on four Chebyshev nodes c_k: N_p(phi) = sum over k of w_pk(phi)
// exp(-p a c_k), where w_pk(phi) does not know sigma_a. Nothing absorbed is exact.

#include <mutex>
#include <optional>
#include <vector>

#include "render_test/material/hair_bsdf.h"

namespace lancret {

/// Spans of the tables in cos(theta_o), 0 to 1, and of the residual's in transmittance.
inline constexpr int kFarRows = 32, kFarDepths = 32;

/// The tables of a model. Linear in cos(theta_o) and phi; built in some milliseconds.
struct FarTable {
    explicit FarTable(const HairModel& model);

    /// A lobe each at one phi, 1/radian. Even in phi.
    struct Node {
        Eigen::Array4f tt = Eigen::Array4f::Zero(), trt = Eigen::Array4f::Zero();  ///< w
        float r = 0;
        float padding[3] = {};
    };
    /// Node integrals over all phi: what of light goes into each lobe.
    using Energy = Node;

    int cells;                    ///< in phi from 0, the viewer's side, to pi
    float least_c;                ///< c is between that and one
    Eigen::Array4f c;             ///< the nodes c_k
    std::vector<Node> nodes;      ///< [rows + 1][cells + 1]
    std::vector<Energy> energy;   ///< [rows + 1]
    std::vector<float> residual;  ///< [rows + 1][kFarDepths + 1], by exp(-a)
    /// Of phi in each of R, TT and TRT where nothing is absorbed: the share below each
    /// node, 0 to 1. [3][rows + 1][cells + 1]
    std::vector<float> distribution;

    std::size_t bytes() const;
};

/// The tables of several models, each made when it is first asked for, by any thread.
class FarTables {
  public:
    explicit FarTables(std::size_t models) : tables_(models) {}
    /// Of model number `i`, always the same one.
    const FarTable& table(std::size_t i, const HairModel& model) const {
        Own& own = tables_[i];
        std::call_once(own.made, [&] { own.table.emplace(model); });
        return *own.table;
    }

  private:
    struct Own {
        std::once_flag made;
        std::optional<FarTable> table;
    };
    mutable std::vector<Own> tables_;
};

/// The lobes at one hit; local axes and meaning of values as HairBsdf's.
class FarHairBsdf {
  public:
    /// `wo` is unit, with y = 0; `sigma_a` is per radius, finite and >= 0. Model and
    /// table must outlive it.
    FarHairBsdf(const HairModel& model, const FarTable& table, const Vec3f& sigma_a,
                const Vec3f& wo);

    BsdfValue evaluate(const Vec3f& wi) const;
    /// What of the light goes into a lobe, over all directions, and its share of samples.
    const Vec3f& lobe_energy(int lobe) const { return energy_[lobe]; }
    float lobe_probability(int lobe) const { return probability_[lobe]; }
    /// `pick` chooses the lobe; all in [0, 1). Nothing where the density underflows.
    std::optional<BsdfSample> sample(float pick, float azimuth,
                                     const Vec2f& longitude) const;

  private:
    BsdfValue evaluate(float sine_i, float cosine_i, float phi) const;
    float sampled_azimuth(int lobe, float pick, float random) const;
    FarTable::Node node(float phi) const;

    const HairModel* model_;
    const FarTable* table_;
    int row_;      ///< of cos(theta_o), and how far it is to the next
    float share_;  ///< 0..1
    TurnedInclination wo_;
    std::array<Eigen::Array4f, 3> once_, twice_;  ///< exp(-p a c_k) of each channel
    std::array<Vec3f, kHairLobes> energy_;
    Eigen::Array4f probability_;  ///< of sampling each lobe
    Eigen::Array4f density_;      ///< that over the lobe's energy without absorption
};

}  // namespace lancret
