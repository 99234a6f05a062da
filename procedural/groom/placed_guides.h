#pragma once
// From a groom's files to guides that stand on its scalp.

#include <memory>
#include <string>
#include <vector>

#include "guides/mesh/scalp.h"
#include "procedural/groom/groom.h"
#include "procedural/groom/stages.h"

namespace lancret {

/// The strands of a groom that have a length: where hair grows.
struct GrownStrands {
    std::vector<Vec3> roots;     ///< [strands], cm
    std::vector<Vec3> tangents;  ///< [strands], unit, at the roots
    Regions regions;
};

/// How guides were placed.
struct PlacementReport {
    StageSeconds seconds;               ///< load and fit
    std::size_t groom_strands = 0;      ///< in the groom's file
    std::size_t snapped_roots = 0;      ///< guides whose root was off the scalp
    double largest_snap = 0;            ///< cm
    std::vector<std::string> warnings;  ///< one line each
};

/// The guides of a groom at rest, and what children are placed with.
struct PlacedGuides {
    Guides guides;
    std::vector<FitReport> fits;    ///< [guides]; empty if the file held guides
    std::vector<Vec3f> normals;     ///< [guides], of the surface at their roots
    std::vector<MeshPoint> places;  ///< [guides], roots on the scalp; empty without one
    std::vector<std::uint32_t> guide_regions;   ///< [guides]; empty: one region
    std::shared_ptr<const GuideLookup> lookup;  ///< search structure over the guides
    std::optional<Scalp> scalp;        ///< the surface that hair grows on, if any
    std::optional<TriangleMesh> body;  ///< the mesh to show, if larger than the scalp
    bool whole_scalp = false;          ///< hair grows everywhere on the scalp
    std::vector<Polyline> partings;    ///< cm, projected onto the scalp if there is one
    GrownStrands grown;
    PlacementReport report;
};

/// The strands that a groom starts from, cm.
struct LoadedGroom {
    Strands strands;
    std::optional<TriangleMesh> scalp, body;  ///< of a groom that Lancret generates
    std::vector<Polyline> partings;           ///< of a groom that Lancret generates
    std::vector<std::uint32_t> dropped;  ///< strands of one point, by number in the file
};

/// Reads or generates a groom's strands and appends any warnings. Throws InputError.
LoadedGroom load_groom(const GroomSettings& groom, std::vector<std::string>& warnings);

/// The groom's scalp mesh, cm; nullopt without one. Throws InputError.
std::optional<TriangleMesh> read_scalp_mesh(const GroomSettings& groom);

/// read_scalp_mesh as a Scalp. Throws InputError, also for a mesh without area.
std::optional<Scalp> load_scalp(const GroomSettings& groom);

/// The groom's partings, or the `made` ones if it sets none, projected onto its scalp,
/// cm. Appends any warnings.
std::vector<Polyline> groom_partings(const GroomSettings& groom,
                                     std::span<const Polyline> made,
                                     const std::optional<Scalp>& scalp,
                                     std::vector<std::string>& warnings);

/// Loads a groom, selects its guides by farthest-point sampling and fits them. The guides
/// of a cache (.h5) are used as they are, in its rest pose or, without one, at its first
/// frame. Throws InputError.
PlacedGuides place_guides(const GroomSettings& groom, const StageCallback& stage = {});

}  // namespace lancret
