#pragma once
// A groom that Lancret makes by itself: for examples, tests and measurements that need no
// file.

#include <cstdint>

#include "guides/base/named.h"
#include "guides/mesh/triangle_mesh.h"
#include "guides/strand/strands.h"

namespace lancret {

/// The head: an ellipsoid about the origin, Y up, the face towards +Z. Half axes, cm.
inline const Vec3 kMadeHead{7.5, 11, 9.5};

/// What is made: hair on a head (make_groom) or grass on a hill (made_lawn.h).
enum class MadeKind { head, lawn };
inline constexpr Named<MadeKind> kMadeKindNames[] = {{MadeKind::head, "head"},
                                                     {MadeKind::lawn, "lawn"}};

struct MadeGroomSettings {
    MadeKind kind = MadeKind::head;
    int strands = 400;
    int points = 64;       ///< of each strand, at least 4
    double shortest = 25;  ///< cm, at the nape
    double longest = 35;   ///< cm, at the crown; lengths go smoothly between
    double curl_radius =
        0.35;  ///< cm, half as much again and half as much here and there
    double curl_wavelength = 4.5;  ///< cm along the strand, a third more and less
    double phase_spread = 0.12;    ///< of a strand's own phase, turns; 0.5 is any phase
    double length_spread = 0;      ///< of a strand's own length, a share of it; below 1
    double frizz = 0.05;           ///< slope of each strand's own fine waves; 0 is sleek
    std::uint64_t seed = 1;
};

/// A head and a wavy, shoulder-length haircut with a parting in the middle.
struct MadeGroom {
    TriangleMesh head;   ///< all of it, with UVs: u about Y from the face, v upwards
    TriangleMesh scalp;  ///< the part within the hairline, with the head's UVs
    /// From the hairline over the crown, on `scalp`; behind its end the hair closes. cm
    /// Empty on a lawn.
    std::vector<Vec3> parting;
    Strands strands;  ///< roots on `scalp`; points evenly spaced
};

/// Makes the groom. The same settings give the same groom, and strand i does not depend
/// on the count. Every segment of a strand has the same length, to rounding in float, so
/// the polyline is as long as its settings ask. No point but the root lies inside the
/// head.
///
/// A strand leaves the scalp near its normal, is combed away from the parting, falls
/// along the head and then freely. Its wave's radius, wavelength and phase are smooth
/// over the scalp, so that neighbours look alike, with a little of its own on top. Throws
/// std::invalid_argument where a setting is out of its range: strands and lengths above
/// 0, waves, spreads and frizz of 0 or more and finite.
MadeGroom make_groom(const MadeGroomSettings& settings);

/// Throws std::invalid_argument where a setting is out of its range.
void check_made(const MadeGroomSettings& settings);

}  // namespace lancret
