#pragma once
// Constants of anchoring, shared by the scalar blends and the curl kernel.

namespace lancret::anchoring {

/// Damps the turn from spine to spine if one nearly vanishes or they are opposed.
template <class T>
inline constexpr T kNone = T(0.01);

/// Damps the tilt of a straight strand, for which the tilt is not defined.
template <class T>
inline constexpr T kSoft = T(0.05);

/// Maximum speed of the tilt: tan(tilt / 2) changes by a factor of at most 1.4.
template <class T>
inline constexpr T kMaxSpeed = T(0.33);

/// Damps the tilt if the spine is too short to have a direction.
template <class T>
inline constexpr T kShort = T(0.05);

}  // namespace lancret::anchoring
