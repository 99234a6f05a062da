#include "procedural/bind/child.h"

#include "guides/helix/helix.h"

namespace lancret {

namespace {

/// Writes the guides of child i with a weight above 0, and their weights divided by the
/// sum. Returns their number.
template <class T>
std::size_t normalized_weights(const Binding& binding, std::size_t i,
                               std::uint32_t* guides, T* weights) {
    const std::size_t k = std::size_t(binding.neighbours);
    std::size_t count = 0;
    T sum = 0;
    for (std::size_t j = i * k; j < (i + 1) * k; ++j) {
        if (!(binding.weights[j] > 0)) continue;
        guides[count] = binding.guides[j];
        weights[count] = T(binding.weights[j]);
        sum += weights[count];
        ++count;
    }
    for (std::size_t j = 0; j < count; ++j) weights[j] /= sum;
    return count;
}

}  // namespace

LightChild light_child(const Binding& binding, std::size_t i) {
    LightChild out;
    out.count = normalized_weights(binding, i, out.guides, out.weights);
    for (std::size_t j = 1; j < out.count; ++j) {
        if (out.weights[j] > out.weights[out.heaviest]) out.heaviest = j;
    }
    return out;
}

template <class T>
BoundChild<T> bound_child(const Binding& binding, const GuideProfiles<T>& profiles,
                          std::size_t i) {
    BoundChild<T> out;
    out.count = normalized_weights(binding, i, out.guides, out.weights);
    const Vec3T<T> up = binding.roots.normals[i].cast<T>();
    for (std::size_t j = 0; j < out.count; ++j) {
        const std::uint32_t g = out.guides[j];
        const Vec3T<T> guide_up = binding.guide_normals[g].cast<T>();
        out.to_space[j] = smallest_rotation<T>(guide_up, up) * profiles.root_frames[g];
    }
    out.length = T(binding.lengths[i]);
    return out;
}

template BoundChild<float> bound_child(const Binding&, const GuideProfiles<float>&,
                                       std::size_t);
template BoundChild<double> bound_child(const Binding&, const GuideProfiles<double>&,
                                        std::size_t);

template <class T>
void synthesize_child(const Binding& binding, const GuideProfiles<T>& profiles,
                      Blend blend, std::size_t i, std::span<HelixState<T>> states) {
    const BoundChild<T> bound = bound_child(binding, profiles, i);
    blend_function<T>(blend)(bound.child(), profiles, states);
}

template void synthesize_child(const Binding&, const GuideProfiles<float>&, Blend,
                               std::size_t, std::span<HelixState<float>>);
template void synthesize_child(const Binding&, const GuideProfiles<double>&, Blend,
                               std::size_t, std::span<HelixState<double>>);

}  // namespace lancret
