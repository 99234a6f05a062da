#pragma once
// The settings of a groom: everything that determines which strands grow.
// docs/formats.md shows its TOML.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "guides/fit/super_helix_fit.h"
#include "guides/made/made_groom.h"
#include "guides/mesh/triangle_mesh.h"
#include "guides/strand/strands.h"
#include "guides/toml/table.h"
#include "procedural/bind/binding.h"
#include "procedural/bind/borders.h"
#include "procedural/expand/expand.h"

namespace lancret {

/// How many of a dense groom's strands become guides: a number or a fraction of them.
struct GuideCount {
    std::optional<std::uint32_t> number = {};
    std::optional<double> share = {};  ///< 0 to 1

    /// The number of guides for `strands` strands; at most 500 if neither is set.
    std::uint32_t of(std::size_t strands) const;
};

/// Parses "400" or "5%". Throws InputError, prefixed with `where`.
GuideCount parse_guide_count(const std::string& text, const std::string& where);

/// The axes and units of a groom's files.
struct SceneUnits {
    Vec3 up = Vec3::UnitY();
    double metres_per_unit = 0.01;
    Vec3 gravity = Vec3(0, -981, 0);  ///< cm/s^2

    double centimetres_per_unit() const { return 100 * metres_per_unit; }
};

struct GroomSettings {
    std::string name;  ///< of the groom's file, for messages
    SceneUnits scene;

    // Inputs. Without a file, strands and scalp are generated from `made`.
    std::filesystem::path strands_file;  ///< .hair; may be empty
    std::filesystem::path guides_file;   ///< .h5 that replaces the fit; may be empty
    std::filesystem::path scalp_file;    ///< .obj; may be empty
    std::shared_ptr<const Strands> own_strands;     ///< replace the file; in scene units
    std::shared_ptr<const TriangleMesh> own_scalp;  ///< replaces the file; in scene units
    MadeGroomSettings made;
    Basis basis = Basis::catmull_rom;  ///< of the points in `strands_file`

    // Guides.
    GuideCount guides;
    FitSettings fit;

    // Children.
    std::optional<double> growth_distance;  ///< cm from the groom's strands; nullopt:
                                            ///< derived from their spacing
    std::optional<std::uint32_t> strands;   ///< nullopt: see child_count
    std::uint64_t seed = 0;
    double density = 1;  ///< fraction of the children to grow, in (0, 1]; see density.h
    BindSettings bind;
    RegionSettings regions;
    std::vector<Polyline> partings;  ///< cm; empty: those of a generated groom, if any
    ExpandSettings expand;
    double tolerance = 0.03;       ///< maximum distance of curves from strands, cm
    std::optional<int> intervals;  ///< per strand; nullopt: chosen by tolerance
    bool adapt = true;             ///< strands may have fewer intervals than the finest

    /// Whether strands may have different interval counts. Not with faces: their rotation
    /// about a straight strand is not measured.
    bool adapts() const { return adapt && !intervals && !expand.has_faces(); }
};

/// The number of children: the groom's setting or, without it, 50,000 on a scalp and one
/// per root of the groom's strands otherwise.
std::uint32_t child_count(const GroomSettings& groom, bool on_scalp, std::size_t roots);

/// Reads the tables [scene], [guides], [scalp], [strands], [regions], [[partings]] and
/// [width]. Other tables are left to the caller. Throws InputError.
GroomSettings read_groom(const TomlTable& toml, std::string name);

}  // namespace lancret
