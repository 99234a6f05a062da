#pragma once
// Guides as interpolation reads them: the Frenet-Serret apparatus at equal steps of s /
// L.

#include <vector>

#include "guides/guides.h"

namespace lancret {

/// One interval of a guide, s / L from i / n to (i + 1) / n. Within it the guide is one
/// helix.
///
/// The Frenet normal of a Super-Helix turns at once about the tangent where two segments
/// meet, by an angle that belongs to the torsion as a whole: `turn` keeps it. N is
/// carried through inflections and straight stretches: it never turns by more than a
/// right angle, and kappa takes the sign instead [TW99, Sec. 4.2].
template <class T>
struct ProfileInterval {
    T kappa;  ///< signed, 1/cm
    T tau;    ///< 1/cm, positive for a right-handed helix
    T turn;   ///< of N about T at the start of the interval, radians in [-pi/2, pi/2]
    Vec3T<T> tangent;  ///< T in the middle of the interval, in the guide's root frame
    Vec3T<T> normal;   ///< N there
};

/// Profiles of any number of guides. Interval i of guide g is intervals[g * count + i];
/// the count + 1 places of guide g begin at g * (count + 1).
template <class T>
struct GuideProfiles {
    int count = 0;  ///< intervals of each guide
    std::vector<ProfileInterval<T>> intervals;
    std::vector<Vec3T<T>> root_normals;  ///< [guides], N at the root, in the root frame
    std::vector<Mat3T<T>> root_frames;   ///< [guides], in space
    std::vector<T> lengths;              ///< [guides], cm
    std::vector<Vec3T<T>> positions;     ///< from the root, in the root frame, cm
    std::vector<Vec3T<T>> tangents;      ///< in the root frame

    std::size_t size() const { return lengths.size(); }
};

/// The profiles of `guides` on `count` intervals. Where the guides' joints lie on the
/// grid (segments of one length, `count` a multiple of their number) the profile is
/// exact; elsewhere an interval with a joint in it becomes the helix that has the same
/// relative rotation.
template <class T>
GuideProfiles<T> guide_profiles(const Guides& guides, int count);

}  // namespace lancret
