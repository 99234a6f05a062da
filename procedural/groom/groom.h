#pragma once
// What a groom says: everything that decides which strands grow. docs/formats.md shows
// its TOML.

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

/// How many of a dense groom's strands become guides: a number, or a share of them all.
struct GuideCount {
    std::optional<std::uint32_t> number = {};
    std::optional<double> share = {};  ///< 0 to 1

    /// Of `strands`: where neither is said, all of up to 500, else 500.
    std::uint32_t of(std::size_t strands) const;
};

/// "400" or "5%". Throws InputError that begins with `where`.
GuideCount parse_guide_count(const std::string& text, const std::string& where);

/// The axes and units of a groom's files.
struct SceneUnits {
    Vec3 up = Vec3::UnitY();
    double metres_per_unit = 0.01;
    Vec3 gravity = Vec3(0, -981, 0);  ///< cm/s^2

    double centimetres_per_unit() const { return 100 * metres_per_unit; }
};

struct GroomSettings {
    std::string name;  ///< of its file, for messages
    SceneUnits scene;
    std::filesystem::path strands_file;  ///< .hair; empty where the groom is made
    std::filesystem::path
        guides_file;  ///< .h5 that stands in for the fit; empty without one
    std::shared_ptr<const Strands> own_strands;  ///< in place of a file, in its unit
    std::shared_ptr<const TriangleMesh> own_scalp;
    MadeGroomSettings made;            ///< of the groom and scalp that Lancret makes
    Basis basis = Basis::catmull_rom;  ///< of the points in `strands_file`
    GuideCount guides;
    FitSettings fit;
    std::filesystem::path scalp_file;  ///< .obj; empty without one
    std::optional<double>
        growth_distance;  ///< cm from the groom's strands; none: by spacing
    std::optional<std::uint32_t> strands;  ///< children; none: child_count says
    std::uint64_t seed = 0;
    double density = 1;  ///< of the children that are grown, in (0, 1]; see density.h
    BindSettings bind;
    RegionSettings regions;
    std::vector<Polyline> partings;  ///< cm; of a made groom none: its own
    ExpandSettings expand;
    double tolerance = 0.03;       ///< cm, of the emitted curves from the strands
    std::optional<int> intervals;  ///< a strand; none: by tolerance
    bool adapt = true;  ///< whether strands that need fewer intervals have fewer

    /// Whether strands may differ in their intervals: faces that turn about a straight
    /// strand are not measured.
    bool adapts() const { return adapt && !intervals && !expand.has_faces(); }
};

/// How many children a groom grows: what it says; else 50,000 on a scalp, and without one
/// a child on each of the groom's own `roots`.
std::uint32_t child_count(const GroomSettings& groom, bool on_scalp, std::size_t roots);

/// Reads the tables [scene], [guides], [scalp], [strands], [regions], [[partings]] and
/// [width]; the other tables of a groom belong to its host, who also finishes the TOML.
GroomSettings read_groom(const TomlTable& toml, std::string name);

}  // namespace lancret
