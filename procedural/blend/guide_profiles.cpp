#include "procedural/blend/guide_profiles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "guides/base/cancel.h"
#include "guides/helix/super_helix.h"

namespace lancret {

namespace {

/// Bending below this many radians an interval has no direction of its own.
constexpr double kStraight = 1e-9;

/// The angle of the Frenet normal about n0 from n1: T' = k2 n1 - k1 n2 = kappa N.
double normal_angle(const Vec3& u) { return std::atan2(-u.y(), u.z()); }

/// Normal angles of the intervals, carried over straight ones from the nearest that
/// bends: from the one before, and at the root from the first that does.
std::vector<double> carried_angles(const std::vector<Vec3>& u, double ds) {
    std::vector<double> angle(u.size());
    const auto bends = [&](const Vec3& k) {
        return std::hypot(k.y(), k.z()) * ds > kStraight;
    };
    const auto first = std::find_if(u.begin(), u.end(), bends);
    double carried = first == u.end() ? 0 : normal_angle(*first);
    for (std::size_t i = 0; i < u.size(); ++i) {
        if (bends(u[i])) carried = normal_angle(u[i]);
        angle[i] = carried;
    }
    return angle;
}

/// The Darboux vector of each interval in the guide's carried frame, and the states at
/// the ends and in the middle of each (2 count + 1 of them).
struct Walk {
    std::vector<Vec3> u;
    std::vector<HelixState<double>> states;
};

Walk walk(const Guides& guides, std::size_t g, int count) {
    const double length = guide_length(guides, g);
    SuperHelix helix = super_helix(guides, g);
    helix.root = {};  // in the root frame, from the root
    std::vector<double> s(2 * count + 1);
    for (std::size_t i = 0; i < s.size(); ++i)
        s[i] = length * double(i) / double(2 * count);

    Walk out;
    out.states.resize(s.size());
    std::vector<std::size_t> segment(s.size());
    sample(helix, s, [&](std::size_t i, std::size_t q, const HelixState<double>& state) {
        out.states[i] = state;
        segment[i] = q;
    });
    std::vector<double> joint(helix.lengths.size() + 1, 0);
    for (std::size_t q = 0; q < helix.lengths.size(); ++q) {
        joint[q + 1] = joint[q] + helix.lengths[q];
    }
    for (int i = 0; i < count; ++i) {
        // The middle lies in one segment; the ends are compared with that segment's
        // joints.
        const std::size_t q = segment[2 * i + 1];
        const double slack = 1e-12 * length;
        if (s[2 * i] >= joint[q] - slack && s[2 * i + 2] <= joint[q + 1] + slack) {
            out.u.push_back(helix.curvatures[q]);
        } else {
            const Mat3 turn =
                out.states[2 * i].frame.transpose() * out.states[2 * i + 2].frame;
            out.u.push_back(rotation_log<double>(turn) * (count / length));
        }
    }
    return out;
}

/// The Darboux vectors, with the two bends told in the rotation-minimising frame in the
/// middle of the interval: the carried frame, turned back by its twist so far.
std::vector<Vec3> bishop_vectors(const Walk& path, double ds) {
    std::vector<Vec3> out;
    double twist = 0;
    for (const Vec3& u : path.u) {
        const double middle = twist + u.x() * ds / 2;
        out.push_back(Eigen::AngleAxisd(middle, Vec3::UnitX()) * u);
        twist += u.x() * ds;
    }
    return out;
}

/// How often the tangent turns round, were it to turn always the same way.
double turns_of(const std::vector<Vec3>& u, double ds) {
    double angle = 0;
    for (const Vec3& k : u) angle += std::hypot(k.y(), k.z()) * ds;
    return angle / (2 * std::numbers::pi);
}

}  // namespace

template <class T>
GuideProfiles<T> guide_profiles(const Guides& guides, int count) {
    const std::size_t size = guides.size(), n = count;
    GuideProfiles<T> out;
    out.count = count;
    out.intervals.resize(size * n);
    out.root_frames.resize(size);
    out.lengths.resize(size);
    out.positions.resize(size * (n + 1));
    out.frames.resize(size * (n + 1));
    out.curvatures.resize(size * n);
    out.bishop.resize(size * n);
    out.basis = spine_basis<T>(count);
    out.spines.resize(size);
    out.advances.resize(size * (n + 1));
    cancellable_for(std::size_t(0), size, [&](std::size_t g) {
        const Walk path = walk(guides, g, count);
        const double length = guide_length(guides, g);
        const std::vector<double> angles = carried_angles(path.u, length / count);
        for (std::size_t i = 0; i < n; ++i) {
            const auto normal = [&](std::size_t place) -> Vec3T<T> {
                const Mat3& frame = path.states[place].frame;
                return (std::cos(angles[i]) * frame.col(1) +
                        std::sin(angles[i]) * frame.col(2))
                    .template cast<T>();
            };
            const Vec3& u = path.u[i];
            out.curvatures[g * n + i] = u.template cast<T>();
            out.intervals[g * n + i] = {T(std::hypot(u.y(), u.z())),
                                        T(u.x()),
                                        path.states[2 * i + 1].frame.col(0).cast<T>(),
                                        normal(2 * i + 1),
                                        normal(2 * i),
                                        normal(2 * i + 2)};
        }
        for (std::size_t i = 0; i <= n; ++i) {
            out.positions[g * (n + 1) + i] = path.states[2 * i].position.cast<T>();
            out.frames[g * (n + 1) + i] = path.states[2 * i].frame.cast<T>();
        }
        const std::vector<Vec3> bishop = bishop_vectors(path, length / count);
        for (std::size_t i = 0; i < n; ++i) {
            out.bishop[g * n + i] = bishop[i].template cast<T>();
        }
        Spine<T>& spine = out.spines[g];
        spine = spine_of<T>(out.basis, T(length), [&](std::size_t i) -> const Vec3T<T>& {
            return out.position(g, i);
        });
        spine.turns = T(turns_of(path.u, length / count));
        const std::array<T, kSpineTerms> taper = spine_taper(spine.turns);
        for (std::size_t i = 0; i <= n; ++i) {
            out.advances[g * (n + 1) + i] =
                std::min<T>(1, spine_at(spine, taper, out.basis.at_places[i]).norm());
        }
        out.root_frames[g] = guides.root_frames[g].cast<T>();
        out.lengths[g] = T(length);
    });
    // Inside a segment N goes on where it was, to round-off.
    constexpr T kJump = T(1e-5);
    out.joints.assign(n, 0);
    for (std::size_t g = 0; g < size; ++g) {
        for (std::size_t i = 1; i < n; ++i) {
            const auto &before = out.intervals[g * n + i - 1],
                       &after = out.intervals[g * n + i];
            if ((after.normal_before - before.normal_after).norm() > kJump ||
                std::abs(after.kappa - before.kappa) > kJump * after.kappa) {
                out.joints[i] = 1;
            }
        }
    }
    return out;
}

template GuideProfiles<float> guide_profiles(const Guides&, int);
template GuideProfiles<double> guide_profiles(const Guides&, int);

}  // namespace lancret
