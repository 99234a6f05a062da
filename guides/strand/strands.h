#pragma once
// Strands as files store them: points along each hair, with their attributes.

#include <cstdint>
#include <span>
#include <vector>

#include "guides/base/named.h"
#include "guides/base/types.h"

namespace lancret {

/// How a strand's points define its curve.
enum class Basis {
    catmull_rom,  ///< the curve passes through them
    bspline,      ///< control points of a uniform cubic B-spline
};
inline constexpr Named<Basis> kBasisNames[] = {{Basis::catmull_rom, "catmull-rom"},
                                               {Basis::bspline, "bspline"}};

/// Strands in flat arrays. An attribute array is empty if the file lacks it.
struct Strands {
    std::vector<std::uint32_t> first{
        0};                     ///< [size + 1] first point of each strand, then the end
    std::vector<Vec3f> points;  ///< [first.back()], cm, from root to tip
    std::vector<float> thickness;          ///< [points] or empty; diameter, cm
    std::vector<float> transparency;       ///< [points] or empty; 0 is opaque
    std::vector<Vec3f> colours;            ///< [points] or empty; linear RGB
    std::vector<Vec2f> uvs;                ///< [points] or empty
    float default_thickness = 0;           ///< diameter, cm, if `thickness` is empty
    float default_transparency = 0;        ///< if `transparency` is empty
    Vec3f default_colour = Vec3f::Zero();  ///< if `colours` is empty
    Basis basis = Basis::catmull_rom;

    std::size_t size() const { return first.size() - 1; }
    std::span<const Vec3f> strand(std::size_t i) const {
        return std::span(points).subspan(first[i], first[i + 1] - first[i]);
    }
};

}  // namespace lancret
