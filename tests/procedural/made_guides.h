#pragma once
// Guides for tests, drawn from a seeded generator.

#include <random>

#include "guides/helix/guides.h"
#include "procedural/blend/blend.h"

namespace lancret::test {

inline Mat3 random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
    return q.normalized().toRotationMatrix();
}

/// Appends a guide with segments of one length.
inline void add_guide(Guides& guides, const std::vector<Vec3>& curvatures, double length,
                      const Mat3& frame = Mat3::Identity(),
                      const Vec3& root = Vec3::Zero()) {
    guides.segments = int(curvatures.size());
    guides.root_positions.push_back(root);
    guides.root_frames.push_back(frame);
    for (const Vec3& u : curvatures) {
        guides.segment_lengths.push_back(length / double(curvatures.size()));
        guides.curvatures.push_back(u);
    }
}

inline Guides random_guides(int count, int segments, unsigned seed,
                            double curvature = 0.5) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, curvature);
    std::uniform_real_distribution<double> length(8, 16), place(-5, 5);
    Guides guides;
    for (int g = 0; g < count; ++g) {
        std::vector<Vec3> u;
        for (int q = 0; q < segments; ++q) {
            u.emplace_back(normal(random), normal(random), normal(random));
        }
        const Vec3 root(place(random), place(random), place(random));
        add_guide(guides, u, length(random), random_rotation(random), root);
    }
    return guides;
}

/// A child of the first guides, without a rotation from guide to child.
template <class T>
struct MadeChild {
    std::vector<std::uint32_t> guides;
    std::vector<T> weights;
    std::vector<Mat3T<T>> to_space;
    T length;

    MadeChild(const GuideProfiles<T>& profiles, std::vector<T> w)
        : weights(std::move(w)) {
        length = 0;
        for (std::size_t k = 0; k < weights.size(); ++k) {
            guides.push_back(std::uint32_t(k));
            to_space.push_back(profiles.root_frames[k]);
            length += weights[k] * profiles.lengths[k];
        }
    }
    Child<T> child() const { return {guides, weights, to_space, length}; }
};

}  // namespace lancret::test
