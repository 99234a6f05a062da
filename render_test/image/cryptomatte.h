#pragma once
// Names as numbers in a picture: Cryptomatte, specification 1.2.0.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace lancret {

/// MurmurHash3, 32 bits for x86 [Appleby 2011].
std::uint32_t murmur_hash3(std::string_view bytes, std::uint32_t seed = 0);

/// The id of a name: its hash with seed 0, made the bits of a float that is neither
/// infinite, nor NaN, nor subnormal ("uint32_to_float32").
std::uint32_t cryptomatte_id(std::string_view name);
float cryptomatte_float(std::string_view name);

/// The name of a layer's object with an id of Image::id: "strand_<n>" from 0, or "head".
std::string object_name(std::uint32_t id);

/// The attributes that tell a reader of the layer `name` in which `objects` are:
/// cryptomatte/<7 hex digits>/name, hash, conversion, manifest.
std::map<std::string, std::string> cryptomatte_metadata(
    std::string_view name, std::initializer_list<std::string_view> objects);

}  // namespace lancret
