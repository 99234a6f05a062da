#pragma once
// Which guides each child has, and by how much: made once, in the rest pose, and never
// changed with time, so that nothing pops.

#include <string>
#include <vector>

#include "guides/guides.h"
#include "procedural/blend.h"
#include "procedural/roots.h"

namespace lancret {

struct BindSettings {
    int neighbours = 4;      ///< guides a child, 1 to kMaxNeighbours
    double exponent = 2;     ///< a of |x - x_k|^-a [TW99, Sec. 4.3], >= 0
    float length_scale = 1;  ///< a child's length over the weighted length of its guides
    bool facing = true;  ///< the factor (S.T_k) H(S.T_k); false where no normal is known
};

/// What binding had to work around, by name.
struct BindReport {
    std::size_t nearest_guide =
        0;  ///< children whose weights all vanished: no guide faces
};

/// Children bound to their guides. Child i owns [i * neighbours, (i + 1) * neighbours) of
/// `guides` and `weights`; unused places have weight 0.
struct Binding {
    int neighbours = 0;
    Roots roots;                        ///< of the children
    std::vector<std::uint32_t> guides;  ///< [children * neighbours]
    std::vector<float> weights;         ///< [children * neighbours], sum 1 for each child
    std::vector<float> lengths;         ///< [children], cm: the intended length
    std::vector<Vec3f>
        guide_normals;  ///< [guides], of the scalp at each guide's root, at rest
    BindReport report;

    std::size_t size() const { return lengths.size(); }
    std::size_t bytes() const;  ///< of the arrays
};

/// Binds children at `roots` to `guides` in their rest pose. `guide_normals` are the
/// scalp's there. The same for any number of threads.
Binding bind(Roots roots, const Guides& guides, std::vector<Vec3f> guide_normals,
             const BindSettings& settings);

/// Child i as a blend reads it, with room for what it points to. `profiles` may be of any
/// time: the turn from guide to child is that of the rest pose.
template <class T>
struct BoundChild {
    std::uint32_t guides[kMaxNeighbours];
    T weights[kMaxNeighbours];
    Mat3T<T> to_space[kMaxNeighbours];
    std::size_t count = 0;
    T length = 0;

    Child<T> child() const {
        return {{guides, count}, {weights, count}, {to_space, count}, length};
    }
};

template <class T>
BoundChild<T> bound_child(const Binding& binding, const GuideProfiles<T>& profiles,
                          std::size_t i);

}  // namespace lancret
