#include "procedural/roots/roots.h"

namespace lancret {

Roots picked(const Roots& roots, std::span<const std::uint32_t> which) {
    Roots out;
    const auto pick = [&](const auto& from, auto& to) {
        if (from.empty()) return;
        to.reserve(which.size());
        for (const std::uint32_t i : which) to.push_back(from[i]);
    };
    pick(roots.positions, out.positions);
    pick(roots.normals, out.normals);
    pick(roots.uvs, out.uvs);
    pick(roots.places, out.places);
    pick(roots.widths, out.widths);
    out.ids.reserve(which.size());
    for (const std::uint32_t i : which) out.ids.push_back(roots.id(i));
    return out;
}

}  // namespace lancret
