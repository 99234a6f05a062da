#pragma once
// lancret_source as Lancret reads it.

#include <optional>
#include <string>

#include "procedural/abi/sized.h"
#include "procedural/groom/groom_source.h"
#include "procedural/lancret_procedural.h"

namespace lancret::abi {

/// A source that was looked at: its counts and pointers are sound.
struct Source {
    GroomSource settings;
    std::uint32_t chunk_strands = 0;
};

/// Throws BadCall.
Source read_source(const lancret_source* given);

/// What tells one groom from another: everything that the source and its TOML say, and
/// the size and time of each file that the groom names, of a long mesh sequence of a
/// thousand of its frames; nothing where it holds a host's own arrays, whose contents no
/// two share. Throws Cancelled.
std::optional<std::string> key_of(const Source& source, const SourcedGroom& sourced);

/// Copies of a host's arrays, every count and number looked at. Throws BadCall, and
/// InputError where a number is no place or an index points nowhere.
std::shared_ptr<const Strands> copied(const lancret_strands* given);
std::shared_ptr<const TriangleMesh> copied(const lancret_mesh* given);

}  // namespace lancret::abi
