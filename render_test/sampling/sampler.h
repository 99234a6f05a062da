#pragma once
// Well-distributed random numbers that depend only on pixel, sample, dimension and seed,
// so that a picture has the same bits for any number of threads.
//
// Pairs of dimensions are a (0, 2)-sequence, Owen-scrambled and shuffled by hashes
// [Burley 2020, "Practical Hash-based Owen Scrambling"]. Different pairs are independent.

#include <array>
#include <cstdint>

#include "guides/base/types.h"

namespace lancret {

/// A 64-bit hash of two numbers: the finaliser of splitmix64 on their combination.
inline std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
    std::uint64_t x = a + 0x9e3779b97f4a7c15u * (b + 1);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

inline std::uint32_t reversed_bits(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// Owen scrambling by a hash in which each bit depends only on higher bits; the constants
/// are Vegdahl's (2021). Input and output have their bits reversed.
inline std::uint32_t scrambled_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// A number in [0, 1) from the upper 24 bits.
inline float unit_float(std::uint32_t bits) { return float(bits >> 8) * 0x1p-24f; }

/// The random numbers of one sample of one pixel.
class Sampler {
  public:
    Sampler(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample)
        : stream_(mix(seed, pixel)), sample_(sample) {}

    /// The next pair of dimensions.
    Vec2f next() {
        const std::uint64_t hash = mix(stream_, pair_++);
        const std::uint64_t scramble = mix(hash, 1);
        const std::uint32_t index = reversed_bits(
            scrambled_reversed(reversed_bits(sample_), std::uint32_t(hash)));
        // The second dimension of the sequence, bits reversed: Pascal's matrix modulo
        // two, whose entry (j, k) is one if the bits of j are among those of k, as five
        // sums.
        std::uint32_t y = index;
        y ^= (y >> 1) & 0x55555555u;
        y ^= (y >> 2) & 0x33333333u;
        y ^= (y >> 4) & 0x0f0f0f0fu;
        y ^= (y >> 8) & 0x00ff00ffu;
        y ^= y >> 16;
        // The first dimension, bits reversed, is the index itself.
        return {
            unit_float(reversed_bits(scrambled_reversed(index, std::uint32_t(scramble)))),
            unit_float(
                reversed_bits(scrambled_reversed(y, std::uint32_t(scramble >> 32))))};
    }

    /// Continues at the given pair, so that a bounce uses the same dimensions on every
    /// path.
    void skip_to(std::uint32_t pair) { pair_ = pair; }

  private:
    std::uint64_t stream_;
    std::uint32_t sample_;
    std::uint32_t pair_ = 0;
};

}  // namespace lancret
