#include "procedural/curves/emitted_curve.h"

#include <algorithm>
#include <cassert>

namespace lancret {

void emit(const SynthesizedStrand& strand, CurveBasis basis, std::span<Point4f> points,
          std::span<Point4f> tangents) {
    assert(!is_derived(basis));
    if (basis == CurveBasis::hermite) {
        hermite_points(strand.states, strand.ds, strand.root, strand.taper, points,
                       tangents);
    } else {
        bspline_points(strand.states, strand.ds, strand.root, strand.taper, points,
                       strand.ends);
    }
}

void emit(const SynthesizedStrand& strand, CurveBasis basis, StrandBuffer& out) {
    const std::size_t n = strand.states.size() - 1;
    const CurveBasis source = layout_of(basis).source;
    out.points.resize(control_points_of(basis, std::uint32_t(n)));
    out.tangents.resize(layout_of(source).has_tangents ? n + 1 : 0);
    if (source == basis) {
        emit(strand, basis, out.points, out.tangents);
        return;
    }
    out.places.resize(n + 1);
    emit(strand, source, out.places, out.tangents);
    points_of_hermite(basis, out.places, out.tangents, out.points);
}

namespace {

/// a x + b y.
Point4f mixed(float a, const Point4f& x, float b, const Point4f& y) {
    return {a * x.x + b * y.x, a * x.y + b * y.y, a * x.z + b * y.z, a * x.w + b * y.w};
}

Point4f with_radius_at_least_zero(Point4f p) {
    p.w = std::max(p.w, 0.0f);
    return p;
}

/// One value per control point of a basis, from n + 1 values at places: linear between
/// places, constant beyond the ends.
template <class At>
void spread(const BasisLayout& layout, std::size_t n, const At& at,
            std::span<Point4f> out) {
    std::size_t j = 0;
    while (j < layout.before) out[j++] = at(0);
    for (std::size_t i = 0; i < n; ++i) {
        out[j++] = at(i);
        for (std::uint32_t q = 1; q < layout.step; ++q) {
            out[j++] = mixed(float(layout.step - q) / float(layout.step), at(i),
                             float(q) / float(layout.step), at(i + 1));
        }
    }
    while (j < out.size()) out[j++] = at(n);
}

}  // namespace

void points_of_hermite(CurveBasis basis, std::span<const Point4f> places,
                       std::span<const Point4f> tangents, std::span<Point4f> points) {
    const std::size_t n = places.size() - 1;
    assert(points.size() == control_points_of(basis, std::uint32_t(n)));
    spread(
        layout_of(basis), n, [&](std::size_t i) { return places[i]; }, points);
    if (basis == CurveBasis::bezier) {
        for (std::size_t i = 0; i < n; ++i) {
            points[3 * i + 1] = mixed(1, places[i], 1.0f / 3, tangents[i]);
            points[3 * i + 2] = mixed(1, places[i + 1], -1.0f / 3, tangents[i + 1]);
        }
    } else if (basis == CurveBasis::catmull_rom) {
        // A Catmull-Rom tangent is half the difference of the neighbouring points.
        points[0] = with_radius_at_least_zero(mixed(1, places[1], -2, tangents[0]));
        points[n + 2] =
            with_radius_at_least_zero(mixed(1, places[n - 1], 2, tangents[n]));
    }
}

void directions_of_hermite(CurveBasis basis, std::span<const Point4f> tangents,
                           std::span<Point4f> directions) {
    spread(
        layout_of(basis), tangents.size() - 1, [&](std::size_t i) { return tangents[i]; },
        directions);
    for (Point4f& d : directions) {
        const Vec3f unit = d.xyz().normalized();
        d = {unit.x(), unit.y(), unit.z(), 0};
    }
}

void normals_in_basis(CurveBasis basis, std::span<const Point4f> ribbon,
                      std::span<Point4f> normals) {
    const BasisLayout &layout = layout_of(basis),
                      &of_ribbon = layout_of(CurveBasis::bspline);
    if (layout.before == of_ribbon.before && layout.extra == of_ribbon.extra) {
        std::ranges::copy(ribbon, normals.begin());
        return;
    }
    spread(
        layout, ribbon.size() - 3, [&](std::size_t i) { return ribbon[i + 1]; }, normals);
}

Vec3f emitted_place(CurveBasis basis, std::span<const Point4f> points,
                    std::span<const Point4f> tangents, std::size_t j, float t) {
    const float r = 1 - t;
    if (basis == CurveBasis::linear) return r * points[j].xyz() + t * points[j + 1].xyz();
    if (basis == CurveBasis::bezier) {
        const auto* p = &points[3 * j];
        return r * r * r * p[0].xyz() + 3 * t * r * (r * p[1].xyz() + t * p[2].xyz()) +
               t * t * t * p[3].xyz();
    }
    if (basis == CurveBasis::catmull_rom) {
        const Vec3f a = points[j].xyz(), b = points[j + 1].xyz(), c = points[j + 2].xyz(),
                    d = points[j + 3].xyz();
        return b + 0.5f * t *
                       ((c - a) +
                        t * ((2 * a - 5 * b + 4 * c - d) + t * (3 * (b - c) + d - a)));
    }
    if (basis == CurveBasis::hermite) {
        return r * r * (1 + 2 * t) * points[j].xyz() +
               t * t * (3 - 2 * t) * points[j + 1].xyz() + t * r * r * tangents[j].xyz() -
               t * t * r * tangents[j + 1].xyz();
    }
    return (r * r * r * points[j].xyz() +
            (4 - 6 * t * t + 3 * t * t * t) * points[j + 1].xyz() +
            (4 - 6 * r * r + 3 * r * r * r) * points[j + 2].xyz() +
            t * t * t * points[j + 3].xyz()) /
           6;
}

namespace {

Vec3 place(const Point4f& p) { return p.xyz().cast<double>(); }

void extend_by_catmull_rom(Eigen::AlignedBox3d& box, std::span<const Point4f> points) {
    for (std::size_t j = 1; j + 1 < points.size(); ++j) {
        const Vec3 p = place(points[j]),
                   sixth = (place(points[j + 1]) - place(points[j - 1])) / 6;
        box.extend(p).extend(p - sixth).extend(p + sixth);
    }
}

void extend_by_hermite(Eigen::AlignedBox3d& box, std::span<const Point4f> points,
                       std::span<const Point4f> tangents) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 p = place(points[i]), third = place(tangents[i]) / 3;
        box.extend(p);
        if (i > 0) box.extend(p - third);
        if (i + 1 < points.size()) box.extend(p + third);
    }
}

void extend_by_bspline(Eigen::AlignedBox3d& box, std::span<const Point4f> points) {
    for (std::size_t j = 1; j + 1 < points.size(); ++j) {
        const Vec3 before = place(points[j - 1]), p = place(points[j]),
                   after = place(points[j + 1]);
        box.extend((before + 4 * p + after) / 6);
        if (j + 2 < points.size()) {
            box.extend((2 * p + after) / 3).extend((p + 2 * after) / 3);
        }
    }
}

}  // namespace

void extend_by_hull(Eigen::AlignedBox3d& box, CurveBasis basis,
                    std::span<const Point4f> points, std::span<const Point4f> tangents) {
    switch (basis) {
        case CurveBasis::bspline:
            return extend_by_bspline(box, points);
        case CurveBasis::hermite:
            return extend_by_hermite(box, points, tangents);
        case CurveBasis::catmull_rom:
            return extend_by_catmull_rom(box, points);
        case CurveBasis::linear:
        case CurveBasis::bezier:
            for (const Point4f& p : points) box.extend(place(p));
    }
}

}  // namespace lancret
