#pragma once
// The roots of a groom's children: spread over its scalp, or on the roots of its strands.

#include <span>
#include <string>

#include "guides/mesh/scalp.h"
#include "procedural/roots/roots.h"

namespace lancret {

/// The roots of all children in compact form: 12 bytes per child on a scalp. One of the
/// two is empty.
struct RootPlaces {
    std::vector<MeshPoint> on_scalp;  ///< [size]
    Roots on_strands;                 ///< [size], for a groom without a scalp

    std::size_t size() const {
        return on_scalp.empty() ? on_strands.size() : on_scalp.size();
    }
    std::size_t bytes() const {
        return on_scalp.size() * sizeof(MeshPoint) + on_strands.bytes();
    }
};

/// `count` places spread evenly over the part of the scalp within `growth` cm of one of
/// `grown`, the roots of the groom's strands; place i does not depend on the count. An
/// infinite `growth` covers the whole scalp. Throws InputError if almost none of the
/// scalp is that near.
std::vector<MeshPoint> places_on_scalp(const Scalp& scalp, std::span<const Vec3> grown,
                                       std::uint32_t count, std::uint64_t seed,
                                       double growth);

/// The roots at all places. `scalp` is null if places are not on one.
Roots roots_at(const Scalp* scalp, RootPlaces places);

/// The roots at the places `which`, which become their ids.
Roots roots_at(const Scalp* scalp, const RootPlaces& places,
               std::span<const std::uint32_t> which);

/// Default growth distance, cm: 1.5 times the 90th percentile of the distance between
/// neighbouring strands.
double growth_of_spacing(std::span<const Vec3> grown);

/// The roots of `count` strands of a groom without a scalp, drawn by a hash of `seed`.
/// Normals are the mean root tangents of the eight nearest strands. Throws InputError,
/// which begins with `name`, if the groom has fewer strands.
Roots roots_of_strands(std::span<const Vec3> grown, std::span<const Vec3> tangents,
                       std::uint32_t count, std::uint64_t seed, const std::string& name);

}  // namespace lancret
