#pragma once
// Hair against bodies and against other hair, as an energy of the whole strand.
//
// Each segment has a few stations, the points of a Gauss rule, that stand for the hair
// about them. A body pushes a station that is deeper than 0 by the penalty of
// [Bergbom07, Sec. 4.2.10], quadratic up to the regularisation depth and linear beyond,
// here as a potential that the implicit step minimises with the rest; so it is as stable
// as the step. Friction is Coulomb's: a station that touches has an anchor on the body
// and is held by a spring to it (stick); where the spring would pull by more than the
// friction the pull stays at that and the anchor follows (slip).

#include <vector>

#include "guides/bodies/colliders.h"
#include "sim/rod/step.h"

namespace lancret {

struct ContactSettings {
    double thickness = 0.05;       ///< cm kept between a body and a guide's centreline
    double stiffness = 1000;       ///< k_c, dyn/cm for each cm of strand
    double regularization = 0.02;  ///< delta_reg, cm, > 0
    double friction = 0.3;         ///< Coulomb's coefficient on bodies
    double free_root = 0.5;        ///< cm from the root that feel no body
    int stations = 4;              ///< a segment
};

/// How far off bodies are looked for, cm. A station further from all than this is not
/// asked for again before it has moved by what it has beyond the thickness.
inline double contact_reach(const ContactSettings& settings) {
    return settings.thickness + 1;
}

/// The penalty of a depth (cm; 0 or less: none), for each cm of strand.
struct Penalty {
    double energy, force, stiffness;  ///< erg/cm, dyn/cm, dyn/cm^2
};
Penalty penalty(double depth, double stiffness, double regularization);

/// A station that touches a body.
struct ContactAnchor {
    SurfaceSample body;            ///< where it touched
    Vec3 position = Vec3::Zero();  ///< of the anchor, in space, cm
    double pressure = 0;           ///< with which it touches, dyn/cm
    bool touches() const { return body.collider >= 0; }
};

/// Takes anchors along with the bodies that they are on; `from` and `to` are shares of
/// the way from the bodies' previous time to the current one.
void carry(const Colliders& colliders, std::span<ContactAnchor> anchors, double from = 0,
           double to = 1);

/// How strands feel each other.
struct StrandContactSettings {
    double radius = 0;           ///< of the strand that a guide stands for, cm; 0: none
    double stiffness = 20;       ///< dyn/cm for each cm of strand
    double friction_across = 0;  ///< viscous, dyn s/cm for each cm of strand
    double friction_along = 0;   ///< the same along the strand, towards its tip
    double cohesion = 0;         ///< dyn/cm for each cm of strand, just beyond touching
};

/// A point of another strand near a station, foreseen to the end of the step.
struct StrandNear {
    Vec3 position;      ///< cm
    Vec3 displacement;  ///< from the step's begin, cm
    Vec3 tangent;       ///< unit, towards its tip
    double share = 0;   ///< of the pair's energy that is this strand's
};

/// No body is within `distance` (cm) of `place`, which is told in the space of body 0: so
/// far a station may go before bodies are asked again. Below 0: not known.
struct Clearance {
    Vec3 position = Vec3::Zero();
    double distance = -1;
};

/// The contact of one strand in one step.
class RodContact : public RodPotential {
  public:
    /// `anchors` ([segments * stations]) are the strand's own and `allowed` (as many, cm,
    /// >= 0) how deep into the penalty each station was in the groom. `near` has
    /// kMaxNear places for each station, `near_counts` says how many are used; empty
    /// without other strands. `places` are where the stations were at the step's begin.
    /// All are kept by reference for as long as this lives.
    struct Strand {
        std::span<const double> lengths;
        std::span<ContactAnchor> anchors;
        std::span<const double> allowed_depths;
        std::span<const Vec3> positions;
        std::span<const StrandNear> near;
        std::span<const std::uint8_t> near_counts;
        /// One a station, kept from step to step and lessened by Colliders::drift(); or
        /// empty, and then forgotten at each begin, as with a mesh that has borders.
        std::span<Clearance> clearances{};
        /// The body that each of `allowed` is told of; empty: all.
        std::span<const int> allowed_bodies{};
    };
    static constexpr int kMaxNear = 4;

    RodContact(const Colliders& colliders, const ContactSettings& settings,
               const StrandContactSettings& strands);

    /// Begins a step that ends at a share of the way from the bodies' previous time to
    /// the current one, which lie `eps` seconds apart.
    void begin(const Strand& strand, double eps, double share = 1);

    double add_to(RodSystem& system, double scale) override;

    /// Takes over what the step came to: pressures, and anchors that slipped. Gives the
    /// depth of the centreline's deepest station below a body's surface, beyond what it
    /// was in the groom, cm, 0 or more.
    double end(const RodSystem& system);

  private:
    SurfaceSample sample(std::size_t station, const Vec3& position);
    double allowance(std::size_t station, const SurfaceSample& body) const;
    double strand_energy(RodSystem& system, const RodSystem::Point& point,
                         std::size_t station, double weight, double scale) const;

    const Colliders& colliders_;
    const ContactSettings& settings_;
    const StrandContactSettings& strands_;
    Strand strand_;
    double eps_ = 0, share_ = 1;
    bool remembers_ = false;
    RigidPose reference_;
    std::vector<Clearance> own_clearances_;
};

}  // namespace lancret
