#pragma once
// Structs that begin with their size, from callers older or newer than the library.

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace lancret::abi {

/// Above any struct of this interface: a size beyond it was never set.
inline constexpr std::size_t kLargestStruct = 4096;

/// A call that breaks the interface's rules.
struct BadCall {
    const char* what;
};

inline void require(bool kept, const char* rule) {
    if (!kept) throw BadCall{rule};
}

/// What the caller gave, with zeros for what it does not know. What this library does not
/// know must be zeros.
template <class T>
T read_sized(const T* in, const char* name) {
    require(in, name);
    require(in->size >= sizeof(std::size_t) && in->size <= kLargestStruct, name);
    T out{};
    std::memcpy(&out, in, std::min(in->size, sizeof(T)));
    const char* bytes = reinterpret_cast<const char*>(in);
    require(std::all_of(bytes + std::min(in->size, sizeof(T)), bytes + in->size,
                        [](char byte) { return byte == 0; }),
            name);
    return out;
}

/// Hands out as much of `value` as the caller knows, and zeros for what it knows besides.
template <class T>
void write_sized(T* out, T value, const char* name) {
    require(out, name);
    const std::size_t size = out->size;
    require(size >= sizeof(std::size_t) && size <= kLargestStruct, name);
    value.size = size;
    std::memcpy(out, &value, std::min(size, sizeof(T)));
    char* bytes = reinterpret_cast<char*>(out);
    std::fill(bytes + std::min(size, sizeof(T)), bytes + size, char(0));
}

}  // namespace lancret::abi
