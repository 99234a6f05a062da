#include "guides/mesh/welded.h"

#include <array>
#include <bit>
#include <cstddef>
#include <unordered_map>

namespace lancret {

namespace {

struct PositionHash {
    std::size_t operator()(const std::array<float, 3>& p) const {
        std::uint64_t h = 0;
        for (const float x : p) {
            h = (h ^ std::bit_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15u;
            h ^= h >> 32;
        }
        return h;
    }
};

}  // namespace

std::vector<std::uint32_t> welded(const std::vector<Vec3f>& positions) {
    std::unordered_map<std::array<float, 3>, std::uint32_t, PositionHash> first;
    first.reserve(positions.size());
    std::vector<std::uint32_t> weld(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        const Vec3f p = positions[i].array() + 0.0f;  // -0 becomes 0
        weld[i] = first.try_emplace({p.x(), p.y(), p.z()}, i).first->second;
    }
    return weld;
}

}  // namespace lancret
