#include "render_test/scene/smooth_normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lancret {
namespace {

constexpr std::size_t kManyAround = 64;

/// The index of each vertex's position: equal for vertices that coincide to a rounding
/// relative to the mesh's size.
std::vector<std::uint32_t> places(const std::vector<Vec3f>& positions) {
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : positions) box.extend(p);
    const double cell = std::max(2e-6 * double(box.diagonal().norm()), 1e-30);
    std::vector<std::array<double, 3>> keys;
    for (const Vec3f& p : positions) {
        const Vec3 k = (p.cast<double>() / cell).array().round();
        keys.push_back({k.x(), k.y(), k.z()});
    }
    std::vector<std::uint32_t> order(positions.size()), out(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return keys[i]; });
    std::uint32_t place = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && keys[order[i]] != keys[order[i - 1]]) ++place;
        out[order[i]] = place;
    }
    return out;
}

/// `v` normalised, or zero.
Vec3f unit(const Vec3f& v) {
    const float length = v.norm();
    return length > 0 && std::isfinite(length) ? Vec3f(v / length) : Vec3f::Zero();
}

float angle_between(const Vec3f& a, const Vec3f& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

CornerNormals corner_normals(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                             const std::vector<Vec3f>& positions, float crease) {
    const std::vector<std::uint32_t> place = places(positions);
    std::vector<Vec3f> faces(triangles.size());
    CornerNormals weighted(triangles.size());  // face normals times the angle
    std::vector<std::uint32_t> first(positions.size() + 1, 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        const std::array<Vec3f, 3> p{positions[a], positions[b], positions[c]};
        const bool thin =
            place[a] == place[b] || place[b] == place[c] || place[c] == place[a];
        faces[t] = thin ? Vec3f::Zero() : unit((p[1] - p[0]).cross(p[2] - p[0]));
        for (int k = 0; k < 3; ++k) {
            const Vec3f& corner = p[k];
            weighted[t][k] =
                angle_between(p[(k + 1) % 3] - corner, p[(k + 2) % 3] - corner) *
                faces[t];
            ++first[place[triangles[t][k]] + 1];
        }
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    // The corners around each position, as 3 * triangle + corner.
    std::vector<std::uint32_t> around(3 * triangles.size()), next(first);
    for (std::uint32_t i = 0; i < around.size(); ++i) {
        around[next[place[triangles[i / 3][i % 3]]]++] = i;
    }

    std::vector<Vec3f> of_all(positions.size(), Vec3f::Zero());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (first[i + 1] - first[i] > kManyAround) {
            for (std::uint32_t j = first[i]; j < first[i + 1]; ++j) {
                of_all[i] += weighted[around[j] / 3][around[j] % 3];
            }
        }
    }

    const float min_cosine = std::cos(crease);
    CornerNormals out(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t here = place[triangles[t][k]];
            Vec3f sum = of_all[here];
            if (first[here + 1] - first[here] <= kManyAround) {
                for (std::uint32_t j = first[here]; j < first[here + 1]; ++j) {
                    if (faces[around[j] / 3].dot(faces[t]) >= min_cosine) {
                        sum += weighted[around[j] / 3][around[j] % 3];
                    }
                }
            }
            const Vec3f normal = unit(sum);
            out[t][k] = normal.dot(faces[t]) > 0 ? normal : faces[t];
        }
    }
    return out;
}

SmoothPlace smooth_place(const std::array<Vec3f, 3>& corners,
                         const std::array<Vec3f, 3>& normals, const Vec3f& weights,
                         const Vec3f& position, const Vec3f& face, const Vec3f& viewer) {
    SmoothPlace out{face, Vec3f::Zero()};
    Vec3f sum = Vec3f::Zero();
    for (int k = 0; k < 3; ++k) {
        sum += weights[k] * normals[k];
        const float below = std::max(0.0f, (corners[k] - position).dot(normals[k]));
        out.lift += weights[k] * below / 2 * normals[k];
    }
    const float length = sum.norm();
    if (!(length > 0.1f)) return {face, Vec3f::Zero()};
    out.normal = sum / length;
    constexpr float kMinCosine = 0.01f;
    const float cosine = out.normal.dot(viewer);
    if (cosine < kMinCosine) {
        out.normal = (out.normal + (kMinCosine - cosine) * viewer).normalized();
    }
    return out;
}

}  // namespace lancret
