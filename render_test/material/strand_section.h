#pragma once
// Strands whose section is an ellipse: where light goes that meets one.

#include <array>

#include "render_test/scene/hit.h"

namespace lancret {

/// The specular paths of one ray from the viewer, traced in the plane across the strand
/// with Bravais' index, by which an inclined ray refracts there as if it were not
/// [Marschner et al. 2003, Sec. 4.3; on ellipses Khungurn and Marschner 2017].
struct SectionPaths {
    std::array<float, 3> azimuth;  ///< of R, TT and TRT, from y towards z, radian
    std::array<float, 3> fresnel;  ///< reflected where the ray enters, and at the next
                                   ///< two places where it meets the surface from inside
    std::array<float, 2> chord;    ///< of TT, and TRT's second, across the strand, radii
};

/// `h` is the offset over the half width, -1..1; `cosine_o` that of the viewer's
/// inclination and `bravais` the index of it. Where a path is reflected totally its
/// Fresnel term is one and the azimuth that it would have left by is any.
SectionPaths section_paths(const StrandSection& section, float h, float cosine_o,
                           float bravais, float eta);

}  // namespace lancret
