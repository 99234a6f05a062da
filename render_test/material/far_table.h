#pragma once
// Tables of far-field lobes: HairBsdf's lobes averaged over the offset h, with
// attenuation inside the average [d'Eon et al. 2011, "An Energy-Conserving Hair
// Reflectance Model", Eq. 10]:
//
//     N_p(phi) = 1/2 integral over h in [-1, 1] of A_p(h) D(phi - Phi_p(h))
//
// One table serves any absorption. A ray crosses the strand p times, each over a length
// of 2 c / cos(theta_t) radii with c = cos(gamma_t) in [sqrt(1 - 1 / eta^2), 1]. So A_p
// contains exp(-p a c) with a = 2 sigma_a / cos(theta_t), which is interpolated in c by
// Lagrange's cubic on four Chebyshev nodes c_k: N_p(phi) = sum over k of w_pk(phi)
// exp(-p a c_k), where w_pk(phi) is independent of sigma_a. Exact without absorption.

#include <mutex>
#include <optional>
#include <vector>

#include "render_test/material/hair_bsdf.h"

namespace lancret {

/// Spans of the tables in cos(theta_o), 0 to 1, and of the residual in transmittance.
inline constexpr int kFarRows = 32, kFarDepths = 32;

/// The table of a model. Linear in cos(theta_o) and phi; takes some milliseconds to
/// build.
struct FarTable {
    explicit FarTable(const HairModel& model);

    /// R, TT and TRT at one phi, 1/radian. Even in phi.
    struct Node {
        Eigen::Array4f tt = Eigen::Array4f::Zero(), trt = Eigen::Array4f::Zero();  ///< w
        float r = 0;
        float padding[3] = {};
    };
    /// Integrals of nodes over all phi: the share of light in each lobe.
    using Energy = Node;

    int cells;                    ///< in phi from 0, the viewer's side, to pi
    float min_c;                  ///< minimum of c; the maximum is one
    Eigen::Array4f c;             ///< the nodes c_k
    std::vector<Node> nodes;      ///< [rows + 1][cells + 1]
    std::vector<Energy> energy;   ///< [rows + 1]
    std::vector<float> residual;  ///< [rows + 1][kFarDepths + 1], by exp(-a)
    /// Distribution functions of phi for R, TT and TRT without absorption, 0 to 1:
    /// [3][rows + 1][cells + 1]
    std::vector<float> distribution;

    std::size_t bytes() const;
};

/// The tables of several models, each built on first use, from any thread.
class FarTables {
  public:
    explicit FarTables(std::size_t models) : tables_(models) {}
    /// The table of model number `i`; `model` must be the same in every call.
    const FarTable& table(std::size_t i, const HairModel& model) const {
        LazyTable& lazy = tables_[i];
        std::call_once(lazy.built, [&] { lazy.table.emplace(model); });
        return *lazy.table;
    }

  private:
    struct LazyTable {
        std::once_flag built;
        std::optional<FarTable> table;
    };
    mutable std::vector<LazyTable> tables_;
};

}  // namespace lancret
