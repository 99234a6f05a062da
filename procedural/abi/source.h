#pragma once
// lancret_source as Lancret reads it.

#include <string>

#include "procedural/abi/sized.h"
#include "procedural/groom_source.h"
#include "procedural/lancret_procedural.h"

namespace lancret::abi {

/// A source that was looked at: its counts and pointers are sound.
struct Source {
    GroomSource settings;
    std::uint32_t chunk_strands = 0;
};

/// Throws BadCall.
Source read_source(const lancret_source* given);

/// What tells one groom from another: everything that the source says, and the size and
/// time of each file that `groom` names; empty where no two are alike.
std::string key_of(const Source& source, const Groom& groom);

}  // namespace lancret::abi
