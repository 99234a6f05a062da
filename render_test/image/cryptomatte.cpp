#include "render_test/image/cryptomatte.h"

#include <fmt/format.h>

#include <bit>

#include "render_test/image/image.h"

namespace lancret {
namespace {

/// Four bytes or fewer, lowest first.
std::uint32_t word(std::string_view bytes) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        out |= std::uint32_t(std::uint8_t(bytes[i])) << (8 * i);
    }
    return out;
}

std::uint32_t scrambled(std::uint32_t word) {
    return std::rotl(word * 0xcc9e2d51u, 15) * 0x1b873593u;
}

}  // namespace

std::uint32_t murmur_hash3(std::string_view bytes, std::uint32_t seed) {
    std::uint32_t hash = seed;
    std::size_t at = 0;
    for (; at + 4 <= bytes.size(); at += 4) {
        hash =
            std::rotl(hash ^ scrambled(word(bytes.substr(at, 4))), 13) * 5 + 0xe6546b64u;
    }
    hash ^= scrambled(word(bytes.substr(at)));
    hash ^= std::uint32_t(bytes.size());
    hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
    hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
    return hash ^ (hash >> 16);
}

std::uint32_t cryptomatte_id(std::string_view name) {
    const std::uint32_t hash = murmur_hash3(name), exponent = (hash >> 23) & 255;
    return exponent == 0 || exponent == 255 ? hash ^ (1u << 23) : hash;
}

float cryptomatte_float(std::string_view name) {
    return std::bit_cast<float>(cryptomatte_id(name));
}

std::string object_name(std::uint32_t id) {
    return id == kMeshId ? "head" : fmt::format("strand_{}", id);
}

std::map<std::string, std::string> cryptomatte_metadata(
    std::string_view name, std::initializer_list<std::string_view> objects) {
    std::string manifest;
    for (const std::string_view object : objects) {
        manifest += fmt::format(R"({}"{}":"{:08x}")", manifest.empty() ? "" : ",", object,
                                cryptomatte_id(object));
    }
    const std::string key =
        "cryptomatte/" + fmt::format("{:08x}", murmur_hash3(name)).substr(0, 7) + "/";
    return {{key + "name", std::string(name)},
            {key + "hash", "MurmurHash3_32"},
            {key + "conversion", "uint32_to_float32"},
            {key + "manifest", "{" + manifest + "}"}};
}

}  // namespace lancret
