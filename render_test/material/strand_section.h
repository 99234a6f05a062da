#pragma once
// Light paths through strands of elliptic section.

#include <array>

#include "render_test/scene/hit.h"

namespace lancret {

/// The specular paths of one ray from the viewer, traced in the plane across the strand
/// with Bravais' index, which accounts for the ray's inclination [Marschner et al. 2003,
/// Sec. 4.3; for ellipses Khungurn and Marschner 2017].
struct SectionPaths {
    std::array<float, 3> azimuth;  ///< of R, TT and TRT, from y towards z, radian
    std::array<float, 3> fresnel;  ///< reflectance where the ray enters and where it
                                   ///< next meets the surface from inside, twice
    std::array<float, 2>
        chord;  ///< of TT, and the second of TRT; across the strand, radii
};

/// `h` is the offset over the half width, -1..1, `cosine_o` the cosine of the viewer's
/// inclination and `bravais` the index for it. At total reflection the Fresnel term is
/// one and the azimuth of exit is arbitrary.
SectionPaths section_paths(const StrandSection& section, float h, float cosine_o,
                           float bravais, float eta);

}  // namespace lancret
