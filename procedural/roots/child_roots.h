#pragma once
// Where the children of a groom stand: spread over its scalp, or on the strands' own
// roots.

#include <span>
#include <string>

#include "guides/mesh/scalp.h"
#include "procedural/roots/roots.h"

namespace lancret {

/// `count` roots spread evenly over the part of the scalp that lies within `growth` cm of
/// one of `grown`, the roots of the groom's strands; root i does not depend on the count.
/// Without a growth distance, one and a half times the spacing that nine in ten strands
/// keep. Throws InputError where next to nothing of the scalp is that near.
Roots roots_on_scalp(const Scalp& scalp, std::span<const Vec3> grown, std::uint32_t count,
                     std::uint64_t seed, double growth);

/// Where children stand, said as shortly as can be: 12 bytes a child on a scalp.
struct RootPlaces {
    std::vector<MeshPoint> on_scalp;  ///< [size]
    Roots own;                        ///< [size] instead, without a scalp

    std::size_t size() const { return on_scalp.empty() ? own.size() : on_scalp.size(); }
    std::size_t bytes() const {
        return on_scalp.size() * sizeof(MeshPoint) + own.bytes();
    }
};

/// The places of roots_on_scalp.
std::vector<MeshPoint> places_on_scalp(const Scalp& scalp, std::span<const Vec3> grown,
                                       std::uint32_t count, std::uint64_t seed,
                                       double growth);

/// The roots of all places. `scalp` may be null where places are not on one.
Roots roots_at(const Scalp* scalp, RootPlaces places);

/// Those of the places `which`, which also are their ids.
Roots roots_at(const Scalp* scalp, const RootPlaces& places,
               std::span<const std::uint32_t> which);

/// How far from its strands a groom may be taken to grow: one and a half times the
/// spacing that nine in ten of them keep, cm.
double growth_of_spacing(std::span<const Vec3> grown);

/// A groom without a scalp: children stand on the roots of its own strands, `count` of
/// them drawn by hash of `seed`. Their normals are the mean root tangents of the eight
/// nearest strands. Throws InputError, beginning with `name`, where the groom has fewer
/// strands.
Roots own_roots(std::span<const Vec3> grown, std::span<const Vec3> tangents,
                std::uint32_t count, std::uint64_t seed, const std::string& name);

}  // namespace lancret
