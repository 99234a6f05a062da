#pragma once
// A generated groom, for examples, tests and benchmarks without files.

#include <cstdint>

#include "guides/base/named.h"
#include "guides/mesh/triangle_mesh.h"
#include "guides/strand/strands.h"

namespace lancret {

/// The head: an ellipsoid about the origin, Y up, the face towards +Z. Half axes, cm.
inline const Vec3 kMadeHead{7.5, 11, 9.5};

/// Hair on a head (make_groom) or grass on a hill (made_lawn.h).
enum class MadeKind { head, lawn };
inline constexpr Named<MadeKind> kMadeKindNames[] = {{MadeKind::head, "head"},
                                                     {MadeKind::lawn, "lawn"}};

struct MadeGroomSettings {
    MadeKind kind = MadeKind::head;
    int strands = 400;
    int points = 64;               ///< per strand, at least 4
    double shortest = 25;          ///< cm, at the nape
    double longest = 35;           ///< cm, at the crown; lengths vary smoothly in between
    double curl_radius = 0.35;     ///< cm; varies between 0.5 and 1.5 of this
    double curl_wavelength = 4.5;  ///< cm along the strand; varies by a third
    double phase_spread = 0.12;    ///< random phase per strand, turns; 0.5 is any phase
    double length_spread = 0;      ///< random change of length per strand, relative; < 1
    double frizz = 0.05;           ///< slope of the random fine waves; 0 is sleek
    std::uint64_t seed = 1;
};

/// A head and a wavy, shoulder-length haircut with a parting in the middle.
struct MadeGroom {
    TriangleMesh head;   ///< complete, with UVs: u about Y from the face, v upwards
    TriangleMesh scalp;  ///< the part within the hairline, with the head's UVs
    /// The middle parting on `scalp`, cm, from the hairline over the crown; behind its
    /// end the hair is not parted. Empty for a lawn.
    std::vector<Vec3> parting;
    Strands strands;  ///< roots on `scalp`; points evenly spaced
};

/// Makes the groom. Equal settings give equal grooms, and strand i does not depend on the
/// count. Every segment of a strand has the same length, to rounding in float, so that
/// the polyline has the length of the settings. Only the root may lie inside the head.
///
/// A strand leaves the scalp near its normal, is combed away from the parting, falls
/// along the head and then freely. The radius, wavelength and phase of its wave are
/// smooth over the scalp, so that neighbours look alike, plus a small random part. Throws
/// std::invalid_argument as check_made does.
MadeGroom make_groom(const MadeGroomSettings& settings);

/// Throws std::invalid_argument if a setting is out of range: strands and lengths must be
/// above 0; waves, spreads and frizz at least 0 and finite.
void check_made(const MadeGroomSettings& settings);

}  // namespace lancret
