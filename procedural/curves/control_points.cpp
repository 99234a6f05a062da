#include "procedural/curves/control_points.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace lancret {

namespace {

/// Two places beyond an end, on the helix of the interval between `end` and `next`.
/// `step` is the signed arc length from `next` to `end`.
std::array<Vec3f, 2> beyond(const HelixState<float>& end, const HelixState<float>& next,
                            float step) {
    const Vec3f u = rotation_log<float>(next.frame.transpose() * end.frame) / step;
    std::array<Vec3f, 2> places;
    HelixState<float> state = end;
    for (Vec3f& place : places) {
        advance<float>(state, u, step);
        place = state.position;
    }
    return places;
}

/// Two places beyond an end, on the parabola through `end` and its next two places.
std::array<Vec3f, 2> beyond(const Vec3f& end, const Vec3f& next, const Vec3f& after) {
    const Vec3f a = next - end, b = after - next;
    return {end - 2 * a + b, end - 5 * a + 3 * b};
}

Point4f point(const Vec3f& p, float radius) { return {p.x(), p.y(), p.z(), radius}; }

}  // namespace

void bspline_points(std::span<const HelixState<float>> states, float ds,
                    const Vec3f& root, const Taper& taper, std::span<Point4f> points,
                    Ends ends) {
    const std::ptrdiff_t n = std::ptrdiff_t(states.size()) - 1;
    assert(std::ptrdiff_t(points.size()) == n + 3);
    // The places beyond the end with index `i`; `inwards` is 1 at the root, -1 at the
    // tip.
    const auto beyond_end = [&](std::ptrdiff_t i, std::ptrdiff_t inwards) {
        if (ends == Ends::helix) {
            return beyond(states[i], states[i + inwards], float(-inwards) * ds);
        }
        const Vec3f &end = states[i].position, &next = states[i + inwards].position;
        return beyond(end, next,
                      n > 1 ? states[i + 2 * inwards].position : Vec3f(2 * next - end));
    };
    const auto before = beyond_end(0, 1), after = beyond_end(n, -1);
    const auto place = [&](std::ptrdiff_t i) -> const Vec3f& {
        if (i < 0) return before[-i - 1];
        if (i > n) return after[i - n - 1];
        return states[i].position;
    };
    const auto radius = [&](std::ptrdiff_t i) {
        return radius_of(taper, i, std::size_t(n));
    };
    // Sums of differences instead of the taps themselves lose fewer digits.
    const auto smoothed = [&](std::ptrdiff_t i) -> Vec3f {
        const Vec3f& p = place(i);
        const Vec3f inner = (place(i - 1) - p) + (place(i + 1) - p);
        const Vec3f outer = (place(i - 2) - p) + (place(i + 2) - p);
        return p + (outer - 10 * inner) / 36;
    };
    for (std::ptrdiff_t i = 0; i <= n; ++i) {
        points[i + 1] = point(root + smoothed(i), radius(i));
    }
    // The curve starts at (c[-1] + 4 c[0] + c[1]) / 6.
    const Vec3f first = 6 * place(0) - 4 * smoothed(0) - smoothed(1);
    const Vec3f last = 6 * place(n) - 4 * smoothed(n) - smoothed(n - 1);
    points[0] = point(root + first, radius(-1));
    points[n + 2] = point(root + last, radius(n + 1));
}

void bspline_directions(std::span<const Point4f> points, std::span<Point4f> directions) {
    for (std::size_t j = 0; j < points.size(); ++j) {
        const std::size_t inner = std::clamp<std::size_t>(j, 1, points.size() - 2);
        const Vec3f unit =
            (points[inner + 1].xyz() - points[inner - 1].xyz()).normalized();
        directions[j] = {unit.x(), unit.y(), unit.z(), 0};
    }
}

Vec2f bent_face(std::span<const HelixState<float>> states) {
    const Mat3f& root = states[0].frame;
    const Vec3f chord = root.transpose() * (states.back().position - states[0].position);
    const float bend = std::hypot(chord.y(), chord.z());
    const bool straight = !(bend > 1e-4f * chord.norm());
    if (straight) return {1, 0};
    return {chord.y() / bend, chord.z() / bend};
}

void ribbon_normals(std::span<const HelixState<float>> states, const Vec2f& face,
                    std::span<Point4f> normals) {
    const std::size_t n = states.size() - 1;
    assert(normals.size() == n + 3);
    const auto normal = [&](std::size_t i) -> Vec3f {
        return face.x() * states[i].frame.col(1) + face.y() * states[i].frame.col(2);
    };
    for (std::size_t i = 0; i <= n; ++i) normals[i + 1] = point(normal(i), 0);
    // The end points are chosen so that the curve passes through the normals at the ends.
    normals[0] = point(2 * normal(0) - normal(1), 0);
    normals[n + 2] = point(2 * normal(n) - normal(n - 1), 0);
}

void hermite_points(std::span<const HelixState<float>> states, float ds,
                    const Vec3f& root, const Taper& taper, std::span<Point4f> points,
                    std::span<Point4f> tangents) {
    const std::size_t n = states.size() - 1;
    assert(points.size() == n + 1 && tangents.size() == n + 1);
    const float slope = (taper.tip - taper.root) / float(n);
    for (std::size_t i = 0; i <= n; ++i) {
        points[i] =
            point(root + states[i].position, radius_of(taper, std::ptrdiff_t(i), n));
        tangents[i] = point(states[i].frame.col(0) * ds, slope);
    }
}

}  // namespace lancret
