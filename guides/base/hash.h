#pragma once
// All of Lancret's randomness: a hash of (seed, strand, salt), the same on every machine
// and for any order of evaluation.

#include <cstdint>

namespace lancret {

/// The finaliser of SplitMix64: every bit of the result depends on every bit of `x`.
///     x ^= x >> 30;  x *= 0xbf58476d1ce4e5b9;
///     x ^= x >> 27;  x *= 0x94d049bb133111eb;
///     x ^= x >> 31;
constexpr std::uint64_t mix_bits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// 64 random bits for a strand. `salt` separates the quantities that are drawn for it.
/// Each of the three is added with the golden gamma g = 0x9e3779b97f4a7c15 and mixed:
///     mix(mix(mix(seed + g) + strand + g) + salt + g),   all modulo 2^64.
/// Test vectors: (0, 0, 0) -> 238275bc38fcbe91, (1, 2, 3) -> 6ae515c1c0ac7e37.
constexpr std::uint64_t hash_bits(std::uint64_t seed, std::uint64_t strand,
                                  std::uint64_t salt) {
    constexpr std::uint64_t kGamma = 0x9e3779b97f4a7c15u;
    return mix_bits(mix_bits(mix_bits(seed + kGamma) + strand + kGamma) + salt + kGamma);
}

/// The highest 53 bits as a number in [0, 1).
constexpr double unit_double(std::uint64_t bits) { return double(bits >> 11) * 0x1p-53; }

/// The highest 24 bits as a number in [0, 1).
constexpr float unit_float(std::uint64_t bits) { return float(bits >> 40) * 0x1p-24f; }

}  // namespace lancret
