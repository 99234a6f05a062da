#include "procedural/curves/control_points.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace lancret {

namespace {

/// The two places beyond an end: the helix of the interval between `end` and `next`,
/// walked away from it. `step` is the signed arc length from `next` to `end`.
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

/// The same on the parabola through `end` and two places from it on.
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
    // The places beyond the end `at`, away from the places `way` from it on.
    const auto beyond_end = [&](std::ptrdiff_t at, std::ptrdiff_t way) {
        if (ends == Ends::helix)
            return beyond(states[at], states[at + way], float(-way) * ds);
        const Vec3f &end = states[at].position, &next = states[at + way].position;
        return beyond(end, next,
                      n > 1 ? states[at + 2 * way].position : Vec3f(2 * next - end));
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
    // Differences, not the taps themselves: a strand of a few centimetres keeps its
    // digits.
    const auto smoothed = [&](std::ptrdiff_t i) -> Vec3f {
        const Vec3f& p = place(i);
        const Vec3f inner = (place(i - 1) - p) + (place(i + 1) - p);
        const Vec3f outer = (place(i - 2) - p) + (place(i + 2) - p);
        return p + (outer - 10 * inner) / 36;
    };
    for (std::ptrdiff_t i = 0; i <= n; ++i)
        points[i + 1] = point(root + smoothed(i), radius(i));
    // The curve is at (c[-1] + 4 c[0] + c[1]) / 6 where it begins.
    const Vec3f first = 6 * place(0) - 4 * smoothed(0) - smoothed(1);
    const Vec3f last = 6 * place(n) - 4 * smoothed(n) - smoothed(n - 1);
    points[0] = point(root + first, radius(-1));
    points[n + 2] = point(root + last, radius(n + 1));
}

void bspline_directions(std::span<const Point4f> points, std::span<Point4f> directions) {
    for (std::size_t j = 0; j < points.size(); ++j) {
        const std::size_t at = std::clamp<std::size_t>(j, 1, points.size() - 2);
        const Vec3f unit = (points[at + 1].xyz() - points[at - 1].xyz()).normalized();
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
    // Such that the normal at the ends is that of the ends.
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

namespace {

/// a x + b y.
Point4f mixed(float a, const Point4f& x, float b, const Point4f& y) {
    return {a * x.x + b * y.x, a * x.y + b * y.y, a * x.z + b * y.z, a * x.w + b * y.w};
}

Point4f not_thinner_than_nothing(Point4f p) {
    p.w = std::max(p.w, 0.0f);
    return p;
}

/// One value for each control point of a basis, of n + 1 values at places: between them
/// and beyond the ends goes straight.
template <class At>
void spread(CurveBasis basis, std::size_t n, const At& at, std::span<Point4f> out) {
    if (basis == CurveBasis::bezier) {
        for (std::size_t i = 0; i < n; ++i) {
            out[3 * i] = at(i);
            out[3 * i + 1] = mixed(2.0f / 3, at(i), 1.0f / 3, at(i + 1));
            out[3 * i + 2] = mixed(1.0f / 3, at(i), 2.0f / 3, at(i + 1));
        }
        out[3 * n] = at(n);
        return;
    }
    const std::size_t before = basis == CurveBasis::catmull_rom ? 1 : 0;
    for (std::size_t i = 0; i <= n; ++i) out[i + before] = at(i);
    if (before) {
        out[0] = at(0);
        out[n + 2] = at(n);
    }
}

}  // namespace

void points_of_hermite(CurveBasis basis, std::span<const Point4f> places,
                       std::span<const Point4f> tangents, std::span<Point4f> points) {
    const std::size_t n = places.size() - 1;
    assert(points.size() == control_points_of(basis, std::uint32_t(n)));
    spread(
        basis, n, [&](std::size_t i) { return places[i]; }, points);
    if (basis == CurveBasis::bezier) {
        for (std::size_t i = 0; i < n; ++i) {
            points[3 * i + 1] = mixed(1, places[i], 1.0f / 3, tangents[i]);
            points[3 * i + 2] = mixed(1, places[i + 1], -1.0f / 3, tangents[i + 1]);
        }
    } else if (basis == CurveBasis::catmull_rom) {
        // The tangent of Catmull-Rom at a place is half of what lies between its
        // neighbours.
        points[0] = not_thinner_than_nothing(mixed(1, places[1], -2, tangents[0]));
        points[n + 2] = not_thinner_than_nothing(mixed(1, places[n - 1], 2, tangents[n]));
    }
}

void directions_of_hermite(CurveBasis basis, std::span<const Point4f> tangents,
                           std::span<Point4f> directions) {
    spread(
        basis, tangents.size() - 1, [&](std::size_t i) { return tangents[i]; },
        directions);
    for (Point4f& d : directions) {
        const Vec3f unit = d.xyz().normalized();
        d = {unit.x(), unit.y(), unit.z(), 0};
    }
}

void normals_in_basis(CurveBasis basis, std::span<const Point4f> ribbon,
                      std::span<Point4f> normals) {
    if (basis == CurveBasis::bspline || basis == CurveBasis::catmull_rom) {
        std::ranges::copy(ribbon, normals.begin());
        return;
    }
    spread(
        basis, ribbon.size() - 3, [&](std::size_t i) { return ribbon[i + 1]; }, normals);
}

}  // namespace lancret
