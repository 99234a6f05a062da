#pragma once
// From a groom's files to guides that stand on its scalp.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "guides/mesh/scalp.h"
#include "procedural/groom/groom.h"

namespace lancret {

/// Wall time of the stages, s.
struct StageSeconds {
    double load = 0, fit = 0, bind = 0;
};

/// Names a stage as it begins.
using StageCallback = std::function<void(const char* stage)>;

/// The guides of a groom, at rest, and what they grew out of.
struct PlacedGuides {
    Guides guides;
    std::vector<FitReport> fits;       ///< [guides]; empty where the file held guides
    std::vector<Vec3f> normals;        ///< [guides], of the surface at their roots
    std::vector<MeshPoint> places;     ///< [guides], of their roots on the scalp, if any
    std::optional<Scalp> scalp;        ///< what hair grows on; nothing without a surface
    std::optional<TriangleMesh> body;  ///< what is seen of it, where that is more
    bool whole_scalp = false;          ///< hair grows everywhere on the scalp
    std::vector<Vec3> grown_roots;     ///< of every strand of the groom, cm
    std::vector<Vec3> grown_tangents;  ///< there
    Regions regions;                   ///< of the groom's strands
    std::vector<std::uint32_t> guide_regions;   ///< [guides], or empty: all are one
    std::shared_ptr<const GuideLookup> lookup;  ///< what binding reads of the guides
    std::vector<Polyline> partings;             ///< cm, on the scalp where there is one
    StageSeconds seconds;                       ///< load and fit
    std::size_t groom_strands = 0;              ///< in the groom's file
    std::size_t snapped_roots = 0;              ///< guides whose root was off the scalp
    double largest_snap = 0;                    ///< cm
    std::vector<std::string> warnings;          ///< a line each
};

/// The strands that a groom starts from, cm.
struct LoadedGroom {
    Strands strands;
    std::optional<TriangleMesh> scalp, body;  ///< of a groom that Lancret makes
    std::vector<Polyline> partings;           ///< of that groom
    std::vector<std::uint32_t> dropped;       ///< strands that its file has besides
};

/// Reads or makes a groom's strands; what is worth telling is added to `warnings`. Throws
/// InputError.
LoadedGroom load_groom(const GroomSettings& groom, std::vector<std::string>& warnings);

/// The mesh that a groom names as its scalp, or holds, cm; nothing where there is none.
/// Throws InputError.
std::optional<TriangleMesh> read_scalp_mesh(const GroomSettings& groom);

/// Reads the mesh that a groom names as its scalp; nothing where it names none. Throws
/// InputError.
std::optional<Scalp> load_scalp(const GroomSettings& groom);

/// The partings that a groom names, or else those it was `made` with, on its scalp, cm;
/// what is worth telling is added to `warnings`.
std::vector<Polyline> groom_partings(const GroomSettings& groom,
                                     std::span<const Polyline> made,
                                     const std::optional<Scalp>& scalp,
                                     std::vector<std::string>& warnings);

/// Loads a groom, chooses its guides by farthest point and fits them. A guide cache (.h5)
/// is taken as it is, in its rest pose; where it has none, at its first frame. Throws
/// InputError.
PlacedGuides groom_guides(const GroomSettings& groom, const StageCallback& stage = {});

}  // namespace lancret
