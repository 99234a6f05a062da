#pragma once
// Object names as numbers in an image: Cryptomatte, specification 1.2.0.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace lancret {

/// MurmurHash3, 32 bits for x86 [Appleby 2011].
std::uint32_t murmur_hash3(std::string_view bytes, std::uint32_t seed = 0);

/// The id of a name: its hash with seed 0, adjusted to the bits of a float that is not
/// infinite, NaN or subnormal ("uint32_to_float32").
std::uint32_t cryptomatte_id(std::string_view name);
float cryptomatte_float(std::string_view name);

/// The object name of an Image::id: "strand_<n>", counted from 0, or "head".
std::string object_name(std::uint32_t id);

/// The attributes that describe layer `name` and its `objects` to a reader:
/// cryptomatte/<7 hex digits>/name, hash, conversion, manifest.
std::map<std::string, std::string> cryptomatte_metadata(
    std::string_view name, std::initializer_list<std::string_view> objects);

}  // namespace lancret
