#include "guides/motion/guides_between.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace lancret {

namespace {

constexpr int kKeys = 4;  // before, from, to, after

/// The weights of the keys at `t` in [0, 1] from `from` to `to`.
using Shares = std::array<double, kKeys>;

Shares linear_shares(double t) { return {0, 1 - t, t, 0}; }

/// Catmull-Rom.
Shares cubic_shares(double t) {
    const double s = 1 - t;
    return {-t * s * s / 2, s * (2 + t * (2 - 3 * t)) / 2, t * (2 + s * (2 - 3 * s)) / 2,
            -s * t * t / 2};
}

struct Key {
    const Guides* guides;
    const std::vector<RigidPose>* carriers;  ///< null: space

    HelixState<double> root(std::size_t g) const {
        const HelixState<double> root = guides->root(g);
        if (!carriers) return root;
        const RigidPose& pose = (*carriers)[g];
        return {pose.rotation.transpose() * root.frame,
                inverse_image(pose, root.position)};
    }
};

void check_alike(const Guides& a, const Guides& b) {
    if (a.size() != b.size() || a.segments != b.segments ||
        a.segment_lengths != b.segment_lengths ||
        a.curvatures.size() != b.curvatures.size()) {
        throw std::invalid_argument("guides_between: expected frames of the same guides");
    }
}

std::array<Key, kKeys> checked_keys(const GuideKeys& keys, const RootCarriers* carriers) {
    if (!keys.from || !keys.to) {
        throw std::invalid_argument("guides_between: expected two frames");
    }
    const auto key = [&](const Guides* guides, const std::vector<RigidPose>* poses) {
        check_alike(*keys.from, *guides);
        if (carriers && poses->size() != guides->size()) {
            throw std::invalid_argument("guides_between: expected one carrier per guide");
        }
        return Key{guides, poses};
    };
    const RootCarriers none;
    const RootCarriers& c = carriers ? *carriers : none;
    const auto of = [&](const std::vector<RigidPose>& poses) {
        return carriers ? &poses : nullptr;
    };
    if (carriers && c.at.size() != keys.from->size()) {
        throw std::invalid_argument("guides_between: expected one carrier per guide");
    }
    const Key from = key(keys.from, of(c.from)), to = key(keys.to, of(c.to));
    return {keys.before ? key(keys.before, of(c.before)) : from, from, to,
            keys.after ? key(keys.after, of(c.after)) : to};
}

/// The rotation vector of `rotation`, plus whole turns about its axis, that is nearest to
/// `expected`.
Vec3 turn_near(const Mat3& rotation, const Vec3& expected) {
    const Vec3 turn = rotation_log<double>(rotation);
    const double angle = turn.norm();
    const Vec3 axis = angle > 1e-9 ? Vec3(turn / angle) : expected.normalized();
    constexpr double kTurn = 2 * kPi;
    return turn + std::round((expected.dot(axis) - angle) / kTurn) * kTurn * axis;
}

/// frames[1] turned by the weighted rotation vectors from it to the keys. `turns` are
/// those of the previous joint (zero at the root), and become those of this joint.
Mat3 blended_frame(const std::array<Mat3, kKeys>& frames, const Shares& shares,
                   std::array<Vec3, kKeys>& turns) {
    const Mat3& base = frames[1];
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < kKeys; ++k) {
        if (k == 1) continue;
        turns[k] = turn_near(base.transpose() * frames[k], turns[k]);
        sum += shares[k] * turns[k];
    }
    Mat3 out = base * helix_step<double>(sum, 1.0).rotation;
    orthonormalize<double>(out);
    return out;
}

/// Computes guide g of `out`, relative to its carrier.
void blend_guide(const std::array<Key, kKeys>& keys, const Shares& shares, InTime in_time,
                 std::size_t g, HelixState<double>& root, Guides& out) {
    std::array<Mat3, kKeys> frames;
    std::array<Vec3, kKeys> turns;
    root.position.setZero();
    for (int k = 0; k < kKeys; ++k) {
        const HelixState<double> own = keys[k].root(g);
        frames[k] = own.frame;
        turns[k].setZero();
        root.position += shares[k] * own.position;
    }
    root.frame = blended_frame(frames, shares, turns);
    Mat3 before = root.frame;
    for (int q = 0; q < out.segments; ++q) {
        const std::size_t i = g * out.segments + q;
        Vec3 mean = Vec3::Zero();
        for (int k = 0; k < kKeys; ++k) {
            mean += shares[k] * keys[k].guides->curvatures[i];
        }
        out.curvatures[i] = mean;
        if (in_time == InTime::curvatures) continue;
        const double ds = out.segment_lengths[i];
        for (int k = 0; k < kKeys; ++k) {
            const Vec3& u = keys[k].guides->curvatures[i];
            frames[k] = (frames[k] * helix_step<double>(u, ds).rotation).eval();
        }
        const Mat3 after = blended_frame(frames, shares, turns);
        out.curvatures[i] = turn_near(before.transpose() * after, mean * ds) / ds;
        before = after;
    }
}

}  // namespace

Guides guides_between(const GuideKeys& guides, double share, InTime in_time,
                      const RootCarriers* carriers) {
    // Written so that a NaN fails.
    if (!(share >= 0 && share <= 1)) {
        throw std::invalid_argument("guides_between: expected a share in [0, 1]");
    }
    const auto keys = checked_keys(guides, carriers);
    if (share == 0) return *guides.from;
    if (share == 1) return *guides.to;
    const Shares shares =
        in_time == InTime::frames ? cubic_shares(share) : linear_shares(share);
    Guides out = *guides.from;
    for (std::size_t g = 0; g < out.size(); ++g) {
        HelixState<double> root;
        blend_guide(keys, shares, in_time, g, root, out);
        if (carriers) {
            const RigidPose& at = carriers->at[g];
            root = {at.rotation * root.frame, at * root.position};
        }
        out.root_frames[g] = root.frame;
        out.root_positions[g] = root.position;
    }
    return out;
}

}  // namespace lancret
