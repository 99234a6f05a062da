#pragma once
// Structs that begin with their size, from callers older or newer than the library.

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace lancret::abi {

/// Larger than any struct of the interface: a larger size is uninitialised memory.
inline constexpr std::size_t kLargestStruct = 4096;

/// The caller broke a rule of the interface.
struct BadCall {
    const char* what;
};

/// Throws BadCall if `kept` is false.
inline void require(bool kept, const char* rule) {
    if (!kept) throw BadCall{rule};
}

/// A copy of the caller's struct; fields that the caller lacks are zero. Throws BadCall
/// with `rule` if it is null or its size is not set, and if fields that this library
/// lacks are not zero.
template <class T>
T read_sized(const T* in, const char* rule) {
    require(in, rule);
    require(in->size >= sizeof(std::size_t) && in->size <= kLargestStruct, rule);
    T out{};
    std::memcpy(&out, in, std::min(in->size, sizeof(T)));
    const char* bytes = reinterpret_cast<const char*>(in);
    require(std::all_of(bytes + std::min(in->size, sizeof(T)), bytes + in->size,
                        [](char byte) { return byte == 0; }),
            "a field that this version of the library lacks is not zero");
    return out;
}

/// Writes the fields of `value` that the caller has, and zeros to those that this library
/// lacks. Throws BadCall with `rule` if it is null or its size is not set.
template <class T>
void write_sized(T* out, T value, const char* rule) {
    require(out, rule);
    const std::size_t size = out->size;
    require(size >= sizeof(std::size_t) && size <= kLargestStruct, rule);
    value.size = size;
    std::memcpy(out, &value, std::min(size, sizeof(T)));
    char* bytes = reinterpret_cast<char*>(out);
    std::fill(bytes + std::min(size, sizeof(T)), bytes + size, char(0));
}

}  // namespace lancret::abi
