#include "procedural/blend/guide_profiles.h"

#include <algorithm>
#include <cmath>

#include "guides/base/cancel.h"
#include "guides/helix/super_helix.h"

namespace lancret {

namespace {

/// The angle of the Frenet normal about n0 from n1: T' = k2 n1 - k1 n2 = kappa N.
double normal_angle(const Vec3& u) { return std::atan2(-u.y(), u.z()); }

/// Normal angles of the intervals. A straight interval takes the angle of the last one
/// before it that bends, or at the root of the first that does.
std::vector<double> carried_angles(const std::vector<Vec3>& u, double ds) {
    std::vector<double> angle(u.size());
    const auto bends = [&](const Vec3& k) {
        return std::hypot(k.y(), k.z()) * ds > kStraightBend;
    };
    const auto first = std::find_if(u.begin(), u.end(), bends);
    double carried = first == u.end() ? 0 : normal_angle(*first);
    for (std::size_t i = 0; i < u.size(); ++i) {
        if (bends(u[i])) carried = normal_angle(u[i]);
        angle[i] = carried;
    }
    return angle;
}

/// One guide on `count` intervals, in its root frame.
struct GuidePath {
    double length;                           ///< cm
    std::vector<Vec3> u;                     ///< [count] Darboux vectors, carried frame
    std::vector<HelixState<double>> states;  ///< [2 count + 1], ends and middles
};

GuidePath path_of(const Guides& guides, std::size_t g, int count) {
    const double length = guide_length(guides, g);
    SuperHelix helix = super_helix(guides, g);
    helix.root = {};
    std::vector<double> s(2 * count + 1);
    for (std::size_t i = 0; i < s.size(); ++i) {
        s[i] = length * double(i) / double(2 * count);
    }
    GuidePath out;
    out.length = length;
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
        // The middle lies in one segment; does the whole interval?
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

/// The Darboux vectors, with both bends expressed in the rotation-minimising frame in the
/// middle of the interval: the carried frame, turned back by its twist so far.
std::vector<Vec3> bishop_vectors(const GuidePath& path, double ds) {
    std::vector<Vec3> out;
    double twist = 0;
    for (const Vec3& u : path.u) {
        const double middle = twist + u.x() * ds / 2;
        out.push_back(Eigen::AngleAxisd(middle, Vec3::UnitX()) * u);
        twist += u.x() * ds;
    }
    return out;
}

/// Integral of kappa over 2 pi.
double turns_of(const std::vector<Vec3>& u, double ds) {
    double angle = 0;
    for (const Vec3& k : u) angle += std::hypot(k.y(), k.z()) * ds;
    return angle / (2 * kPi);
}

/// Writes intervals, places and Darboux vectors of guide g.
template <class T>
void write_path(const GuidePath& path, std::size_t g, GuideProfiles<T>& out) {
    const std::size_t n = out.count;
    const double ds = path.length / out.count;
    const std::vector<double> angles = carried_angles(path.u, ds);
    for (std::size_t i = 0; i < n; ++i) {
        const auto normal = [&](std::size_t place) -> Vec3T<T> {
            const Mat3& frame = path.states[place].frame;
            return (std::cos(angles[i]) * frame.col(1) +
                    std::sin(angles[i]) * frame.col(2))
                .template cast<T>();
        };
        const Vec3& u = path.u[i];
        out.curvatures[g * n + i] = u.template cast<T>();
        out.intervals[g * n + i] = {
            T(std::hypot(u.y(), u.z())),
            T(u.x()),
            path.states[2 * i + 1].frame.col(0).template cast<T>(),
            normal(2 * i + 1),
            normal(2 * i),
            normal(2 * i + 2)};
    }
    for (std::size_t i = 0; i <= n; ++i) {
        out.positions[g * (n + 1) + i] = path.states[2 * i].position.template cast<T>();
        out.frames[g * (n + 1) + i] = path.states[2 * i].frame.template cast<T>();
    }
    const std::vector<Vec3> bishop = bishop_vectors(path, ds);
    for (std::size_t i = 0; i < n; ++i) {
        out.bishop[g * n + i] = bishop[i].template cast<T>();
    }
}

/// Writes the spine and the advances of guide g, whose positions are written.
template <class T>
void write_spine(const GuidePath& path, std::size_t g, GuideProfiles<T>& out) {
    const std::size_t n = out.count;
    Spine<T>& spine = out.spines[g];
    spine = spine_of<T>(out.basis, T(path.length), [&](std::size_t i) -> const Vec3T<T>& {
        return out.position(g, i);
    });
    spine.turns = T(turns_of(path.u, path.length / out.count));
    const std::array<T, kSpineTerms> taper = spine_taper(spine.turns);
    for (std::size_t i = 0; i <= n; ++i) {
        out.advances[g * (n + 1) + i] =
            std::min<T>(1, spine_at(spine, taper, out.basis.at_places[i]).norm());
    }
}

/// [count] 1 if N or kappa of any guide jumps at the interval's start.
template <class T>
std::vector<char> joints_of(const GuideProfiles<T>& profiles) {
    // Inside a segment N is continuous to round-off.
    constexpr T kJump = T(1e-5);
    const std::size_t n = profiles.count;
    std::vector<char> out(n, 0);
    for (std::size_t g = 0; g < profiles.size(); ++g) {
        for (std::size_t i = 1; i < n; ++i) {
            const auto &before = profiles.intervals[g * n + i - 1],
                       &after = profiles.intervals[g * n + i];
            if ((after.normal_before - before.normal_after).norm() > kJump ||
                std::abs(after.kappa - before.kappa) > kJump * after.kappa) {
                out[i] = 1;
            }
        }
    }
    return out;
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
        const GuidePath path = path_of(guides, g, count);
        write_path(path, g, out);
        write_spine(path, g, out);
        out.root_frames[g] = guides.root_frames[g].template cast<T>();
        out.lengths[g] = T(path.length);
    });
    out.joints = joints_of(out);
    return out;
}

template GuideProfiles<float> guide_profiles(const Guides&, int);
template GuideProfiles<double> guide_profiles(const Guides&, int);

}  // namespace lancret
