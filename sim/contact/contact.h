#pragma once
// Contact of hair with bodies and with other hair, as an energy of the whole strand.
//
// Each segment has a few stations, the points of a Gauss rule, that represent the hair
// around them. A body pushes a station of positive depth by the penalty of
// [Bergbom07, Sec. 4.2.10], quadratic up to the regularisation depth and linear beyond,
// here as a potential that the implicit step minimises with the rest, so that contact is
// as stable as the step. Friction is Coulomb's: a touching station has an anchor on the
// body and is held to it by a spring (stick). If the spring would pull harder than the
// friction limit, the pull stays at the limit and the anchor follows (slip).

#include <vector>

#include "guides/bodies/colliders.h"
#include "sim/rod/step.h"

namespace lancret {

struct ContactSettings {
    double thickness = 0.05;       ///< cm kept between a body and a guide's centreline
    double stiffness = 1000;       ///< k_c, dyn/cm per cm of strand
    double regularization = 0.02;  ///< delta_reg, cm, > 0
    double friction = 0.3;         ///< Coulomb's coefficient on bodies
    double free_root = 0.5;        ///< cm from the root without contact with bodies
    int stations = 4;              ///< per segment
};

/// Search distance for bodies, cm. A station further than this from all bodies is not
/// tested again until it has moved by its distance in excess of the thickness.
inline double contact_reach(const ContactSettings& settings) {
    return settings.thickness + 1;
}

/// The penalty per cm of strand at a depth (cm); zero if the depth is not above 0.
struct Penalty {
    double energy, force, stiffness;  ///< erg/cm, dyn/cm, dyn/cm^2
};
Penalty penalty(double depth, double stiffness, double regularization);

/// The contact of a station with a body.
struct ContactAnchor {
    SurfaceSample body;            ///< where the station touched it
    Vec3 position = Vec3::Zero();  ///< of the anchor, world, cm
    double pressure = 0;           ///< of the contact, dyn/cm
    bool touches() const { return body.collider >= 0; }
};

/// Moves anchors with the bodies that they are on; `from` and `to` are fractions of the
/// time from the bodies' previous pose to the current one.
void carry(const Colliders& colliders, std::span<ContactAnchor> anchors, double from = 0,
           double to = 1);

/// Contact between strands.
struct StrandContactSettings {
    double radius = 0;      ///< of the strand that a guide represents, cm; 0: no contact
    double stiffness = 20;  ///< dyn/cm per cm of strand
    double friction_across = 0;  ///< viscous, dyn s/cm per cm of strand
    double friction_along = 0;   ///< likewise, along the strand
    double cohesion = 0;         ///< dyn/cm per cm of strand, just beyond touching
};

/// A point of another strand near a station, extrapolated to the end of the step.
struct StrandNear {
    Vec3 position;      ///< cm
    Vec3 displacement;  ///< since the start of the step, cm
    Vec3 tangent;       ///< unit, towards its tip
    double share = 0;   ///< of the pair's energy that belongs to this strand
};

/// No body is within `distance` (cm) of `position`, in the frame of body 0; a station may
/// move this far before the next query. Below 0: unknown.
struct Clearance {
    Vec3 position = Vec3::Zero();
    double distance = -1;
};

/// The contact of one strand in one step.
class RodContact : public RodPotential {
  public:
    /// The strand in contact. The arrays must outlive the step; n is the number of
    /// segments times the stations per segment.
    struct Strand {
        std::span<const double> lengths;   ///< [segments], cm
        std::span<ContactAnchor> anchors;  ///< [n]
        /// [n], cm, >= 0: the depth into the penalty of each station in the groom.
        std::span<const double> allowed_depths;
        /// [n], cm, at the start of the step; empty without other strands.
        std::span<const Vec3> positions;
        /// [n * kMaxNear], of which `near_counts` ([n]) are used per station; both empty
        /// without other strands.
        std::span<const StrandNear> near;
        std::span<const std::uint8_t> near_counts;
        /// [n], kept from step to step and reduced by Colliders::drift(). If empty, or if
        /// a mesh has borders, clearances are forgotten at each begin().
        std::span<Clearance> clearances{};
        /// [n], the body that each allowed depth applies to; empty: all bodies.
        std::span<const int> allowed_bodies{};
    };
    static constexpr int kMaxNear = 4;

    RodContact(const Colliders& colliders, const ContactSettings& settings,
               const StrandContactSettings& strands);

    /// Begins a step that ends at the fraction `share` of the time from the bodies'
    /// previous pose to the current one; the two are `eps` seconds apart.
    void begin(const Strand& strand, double eps, double share = 1);

    double add_to(RodSystem& system, double scale) override;

    /// Updates pressures and anchors from the end of the step. Returns the depth of the
    /// centreline's deepest station below a body's surface, in excess of its depth in the
    /// groom, cm, >= 0.
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
