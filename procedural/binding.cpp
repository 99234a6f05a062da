#include "procedural/binding.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <stdexcept>

#include "guides/point_tree.h"
#include "procedural/weights.h"

namespace lancret {

std::size_t Binding::bytes() const {
    return roots.bytes() + guides.size() * sizeof(guides[0]) +
           weights.size() * sizeof(float) + lengths.size() * sizeof(float) +
           guide_normals.size() * sizeof(Vec3f);
}

Binding bind(Roots roots, const Guides& guides, std::vector<Vec3f> guide_normals,
             const BindSettings& settings) {
    if (guides.size() == 0) throw std::invalid_argument("bind: no guides");
    if (settings.neighbours < 1 || settings.neighbours > kMaxNeighbours) {
        throw std::invalid_argument("bind: neighbours out of range");
    }
    Binding out;
    const std::size_t k = std::min<std::size_t>(settings.neighbours, guides.size());
    const std::size_t children = roots.size();
    out.neighbours = int(k);
    out.roots = std::move(roots);
    out.guide_normals = std::move(guide_normals);
    out.guides.resize(children * k);
    out.weights.resize(children * k);
    out.lengths.resize(children);

    std::vector<double> lengths(guides.size());
    for (std::size_t g = 0; g < guides.size(); ++g) lengths[g] = guide_length(guides, g);
    const PointTree tree(guides.root_positions);

    const auto bind_range = [&](const tbb::blocked_range<std::size_t>& range,
                                std::size_t alone) {
        std::array<std::uint32_t, kMaxNeighbours + 1> near;
        std::array<double, kMaxNeighbours + 1> squared, distance, facing;
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const Vec3 x = out.roots.positions[i].cast<double>();
            const Vec3 up = out.roots.normals[i].cast<double>();
            const std::size_t found =
                tree.nearest(x, {near.data(), k + 1}, {squared.data(), k + 1});
            for (std::size_t j = 0; j < found; ++j) {
                distance[j] = std::sqrt(squared[j]);
                facing[j] =
                    settings.facing ? up.dot(guides.root_frames[near[j]].col(0)) : 1.0;
            }
            const double reach =
                found > k ? distance[k] : std::numeric_limits<double>::infinity();
            const std::span<float> weights(&out.weights[i * k], k);
            if (!guide_weights({distance.data(), k}, reach, {facing.data(), k},
                               settings.exponent, weights)) {
                ++alone;
            }
            double length = 0;
            for (std::size_t j = 0; j < k; ++j) {
                out.guides[i * k + j] = near[j];
                length += double(weights[j]) * lengths[near[j]];
            }
            out.lengths[i] = float(length * settings.length_scale);
        }
        return alone;
    };
    out.report.nearest_guide =
        tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, children, 1024),
                             std::size_t(0), bind_range, std::plus<>());
    return out;
}

template <class T>
BoundChild<T> bound_child(const Binding& binding, const GuideProfiles<T>& profiles,
                          std::size_t i) {
    BoundChild<T> out;
    const std::size_t k = binding.neighbours;
    const Vec3T<T> up = binding.roots.normals[i].cast<T>();
    T sum = 0;
    for (std::size_t j = 0; j < k; ++j) {
        const float weight = binding.weights[i * k + j];
        if (!(weight > 0)) continue;
        const std::uint32_t g = binding.guides[i * k + j];
        const Vec3T<T> guide_up = binding.guide_normals[g].cast<T>();
        out.guides[out.count] = g;
        out.weights[out.count] = T(weight);
        out.to_space[out.count] =
            smallest_rotation<T>(guide_up, up) * profiles.root_frames[g];
        sum += T(weight);
        ++out.count;
    }
    for (std::size_t j = 0; j < out.count; ++j) out.weights[j] /= sum;
    out.length = T(binding.lengths[i]);
    return out;
}

template BoundChild<float> bound_child(const Binding&, const GuideProfiles<float>&,
                                       std::size_t);
template BoundChild<double> bound_child(const Binding&, const GuideProfiles<double>&,
                                        std::size_t);

}  // namespace lancret
