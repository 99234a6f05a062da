#pragma once
// lancret_source, validated and copied.

#include <optional>
#include <string>

#include "procedural/abi/sized.h"
#include "procedural/groom/groom_source.h"
#include "procedural/lancret_procedural.h"

namespace lancret::abi {

/// A copy of a lancret_source.
struct Source {
    GroomSource settings;
    std::uint32_t chunk_strands = 0;
};

/// Validates and copies. Throws BadCall, and InputError if a position or UV is not
/// finite, an index is out of range or a strand has too few points.
Source read_source(const lancret_source* given);

/// The groom of a source, its TOML checked for unknown keys. The tables that programs
/// which show or simulate a groom read from the same file ([camera], [light], [material],
/// [render], [dynamics], [[colliders]]) are ignored. Throws InputError.
SourcedGroom read_groom(const Source& source);

/// A key that differs between grooms with different strands: the contents of the source
/// and its TOML, and path, size and time of each file that the groom names (of at most
/// about 1000 files of a mesh sequence). nullopt if the source has arrays of the host,
/// which are never shared. Throws Cancelled.
std::optional<std::string> key_of(const Source& source, const SourcedGroom& sourced);

}  // namespace lancret::abi
