#pragma once
// What a groom says: everything that decides which strands grow. docs/formats.md shows
// its TOML.

#include <filesystem>
#include <optional>

#include "guides/made_groom.h"
#include "guides/strands.h"
#include "guides/super_helix_fit.h"
#include "procedural/binding.h"
#include "procedural/expand.h"
#include "procedural/toml_table.h"

namespace lancret {

/// How many of a dense groom's strands become guides: a number, or a share of them all.
struct GuideCount {
    std::optional<std::uint32_t> number;
    std::optional<double> share;  ///< 0 to 1

    /// Of `strands`: all of up to 500, else 500, where neither is said.
    std::uint32_t of(std::size_t strands) const;
};

/// "400" or "5%"; throws InputError that begins with `where`.
GuideCount parse_guide_count(const std::string& text, const std::string& where);

struct Groom {
    std::string name;                       ///< of the file, for messages
    std::filesystem::path strands_file;     ///< .hair; empty where the groom is made
    std::optional<MadeGroomSettings> made;  ///< a groom and scalp that Lancret makes
    Basis basis = Basis::catmull_rom;       ///< of the points in `strands_file`
    GuideCount guides;
    FitSettings fit;
    std::optional<std::filesystem::path> scalp_file;  ///< .obj
    std::optional<double>
        growth_distance;             ///< cm from a strand of the groom; none: by spacing
    std::uint32_t strands = 100000;  ///< children
    std::uint64_t seed = 0;
    BindSettings bind;
    ExpandSettings expand;
    double tolerance = 0.005;      ///< cm, of control points from the guides
    std::optional<int> intervals;  ///< a strand; none: by tolerance
};

/// Reads the tables [guides], [scalp], [strands] and [width] of a groom; does not finish
/// it: [scene], [camera], [material], [light] and [render] belong to the host.
Groom read_groom(const TomlTable& toml, std::string name);

/// The groom that a .hair file is by itself.
Groom groom_of_hair(const std::filesystem::path& file);

}  // namespace lancret
